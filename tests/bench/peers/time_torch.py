#!/usr/bin/env python3
"""time_torch.py NETWORK step|forward|export PRECISION SECONDS [FILE.onnx]: prints the CPU milliseconds of a training
step with 32 images, or of one image's forward pass, in Python PyTorch on one thread; or writes the network as ONNX."""
import statistics
import sys
import time

import torch

from dd_network import DDNetwork


def images(count):
    drawn = (torch.rand(count, 1, 224, 224) > 0.999).float()
    return drawn.contiguous(memory_format=torch.channels_last)


def median_ms(run, seconds):
    """The median CPU and wall time of `run`, after one run to warm up."""
    run()
    cpu_ms, wall_ms, end = [], [], time.monotonic() + seconds
    while time.monotonic() < end or len(cpu_ms) < 5:
        cpu, wall = time.process_time(), time.monotonic()
        run()
        cpu_ms.append(1e3 * (time.process_time() - cpu))
        wall_ms.append(1e3 * (time.monotonic() - wall))
    return statistics.median(cpu_ms), statistics.median(wall_ms)


def step_of(network, precision):
    network.train()
    parameters = list(network.parameters())
    optimizer = torch.optim.Adam(parameters)
    batch, classes = images(32), torch.arange(32) % 2

    def step():
        with torch.autocast("cpu", torch.bfloat16, enabled=precision == "bf16"):
            logits = network(batch)
        optimizer.zero_grad(set_to_none=True)
        torch.nn.functional.cross_entropy(logits, classes).backward()
        torch.nn.utils.clip_grad_norm_(parameters, 1.0)
        optimizer.step()

    return step


def forward_of(network):
    image = images(1)

    def forward():
        with torch.no_grad():
            network(image)

    return forward


def main():
    name, task, precision, seconds = sys.argv[1], sys.argv[2], sys.argv[3], float(sys.argv[4])
    torch.set_num_threads(1)
    torch.manual_seed(1)
    network = DDNetwork(name).to(memory_format=torch.channels_last).eval()
    if task == "export":
        torch.onnx.export(network, torch.zeros(1, 1, 224, 224), sys.argv[5], opset_version=13)
        return
    run = step_of(network, precision) if task == "step" else forward_of(network)
    print(*median_ms(run, seconds))


if __name__ == "__main__":
    main()
