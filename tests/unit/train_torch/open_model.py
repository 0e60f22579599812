"""Opens an exported model in Python and compares its answers: open_model.py MODEL.pt IMAGES VALUES. The last two are files
of raw float32 values. Exits 1 if a value differs by more than 1e-5 or the description is missing."""
import json
import sys

import numpy
import torch

model_path, images_path, values_path = sys.argv[1:]
extra = {"ddtool.json": ""}
model = torch.jit.load(model_path, _extra_files=extra)
size_px = json.loads(extra["ddtool.json"])["image"]["size_px"]
images = torch.from_numpy(numpy.fromfile(images_path, numpy.float32).reshape(-1, 1, size_px, size_px))
values = torch.from_numpy(numpy.fromfile(values_path, numpy.float32).reshape(-1, 2))
with torch.no_grad():
    difference = (model(images) - values).abs().max().item()
print("largest difference", difference)
sys.exit(0 if difference <= 1e-5 else 1)
