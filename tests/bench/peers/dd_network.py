"""DD-Model and ddmodel-lite (docs/models.md) in plain Python PyTorch, written as is usual there."""
import torch
from torch import nn

TABLES = {
    "ddmodel": {"stem": (32, 2), "groups": [(32, 1), (64, 2), (128, 1), (256, 1)], "heads": 1, "tokens": 28 * 28},
    "ddmodel-lite": {"stem": (16, 4), "groups": [(16, 1), (32, 2), (64, 2)], "heads": 2, "tokens": 7 * 7},
}
WIDTH = 64
FEED_FORWARD = 128


def conv_norm(inputs, outputs, kernel_px, stride):
    return nn.Sequential(nn.Conv2d(inputs, outputs, kernel_px, stride, kernel_px // 2, bias=False),
                         nn.BatchNorm2d(outputs))


class BasicBlock(nn.Module):
    def __init__(self, inputs, outputs, stride):
        super().__init__()
        self.first = conv_norm(inputs, outputs, 3, stride)
        self.second = conv_norm(outputs, outputs, 3, 1)
        same = inputs == outputs and stride == 1
        self.projection = nn.Identity() if same else conv_norm(inputs, outputs, 1, stride)

    def forward(self, x):
        return torch.relu(self.second(torch.relu(self.first(x))) + self.projection(x))


class EncoderLayer(nn.Module):
    def __init__(self, heads):
        super().__init__()
        self.heads = heads
        self.attention_norm = nn.LayerNorm(WIDTH)
        self.query_key_value = nn.Linear(WIDTH, 3 * WIDTH)
        self.attention_out = nn.Linear(WIDTH, WIDTH)
        self.feed_forward = nn.Sequential(nn.LayerNorm(WIDTH), nn.Linear(WIDTH, FEED_FORWARD), nn.ReLU(),
                                          nn.Linear(FEED_FORWARD, WIDTH))

    def forward(self, x):
        x = x + self.attention(self.attention_norm(x))
        return x + self.feed_forward(x)

    def attention(self, x):
        count, tokens, width = x.shape
        parts = self.query_key_value(x).view(count, tokens, 3, self.heads, width // self.heads)
        query, key, value = parts.permute(2, 0, 3, 1, 4).unbind(0)
        shares = torch.softmax(query @ key.transpose(-2, -1) * (width // self.heads) ** -0.5, -1)
        return self.attention_out((shares @ value).transpose(1, 2).reshape(count, tokens, width))


class DDNetwork(nn.Module):
    """From images [n, 1, 224, 224] to logits [n, 2]."""

    def __init__(self, name):
        super().__init__()
        table = TABLES[name]
        channels, stride = table["stem"]
        self.stem = conv_norm(1, channels, 7, stride)
        blocks = []
        for outputs, group_stride in table["groups"]:
            blocks.append(BasicBlock(channels, outputs, group_stride))
            channels = outputs
        self.groups = nn.Sequential(*blocks)
        self.embedding = nn.Linear(channels, WIDTH)
        self.position = nn.Parameter(0.02 * torch.randn(table["tokens"], WIDTH))
        self.encoder = EncoderLayer(table["heads"])
        self.norm = nn.LayerNorm(WIDTH)
        self.head = nn.Linear(WIDTH, 2)

    def forward(self, images):
        map_ = self.groups(torch.relu(torch.max_pool2d(self.stem(images), 3, 2, 1)))
        tokens = self.embedding(map_.flatten(2).transpose(1, 2)) + self.position
        return self.head(self.norm(self.encoder(tokens)).mean(1).float())
