"""A network of PyTorch as detector, trained on swarms from the simulator: torch_detector.py

The label of a swarm is what the simulator knows: whether the scan tells less of the pose along its weakest direction than
the odometry does. The network sees the image of the step swarm, 32 pixels wide."""

import numpy as np
import torch

import ddtool

IMAGE = {"swarm": "step", "size_px": 32}
Samples = list[tuple[torch.Tensor, float]]


def image_of(swarm: ddtool.Swarm) -> torch.Tensor:
    return torch.from_numpy(ddtool.render(swarm, settings=IMAGE)).float().div(255.0).reshape(1, 32, 32)


def is_degenerate(scan: ddtool.Scan, update: ddtool.Update) -> float:
    information = scan.fisher_information
    assert information is not None
    variances, axes = np.linalg.eigh(np.linalg.inv(information + 1e-6 * np.eye(3))[:2, :2])
    moved = np.cov(update.swarm.predicted_motions[:, :2].T)
    weakest = axes[:, -1]
    return float(variances[-1] > weakest @ moved @ weakest)


def samples_of(world: str) -> Samples:
    slam = ddtool.Slam("rbpf", particles=30, seed=1)
    samples: Samples = []
    for scan in ddtool.simulate(world, settings={"lidar.preset": "rplidar-a1"}):
        update = slam.update(scan)
        if update is not None and update.number > 0:
            samples.append((image_of(update.swarm), is_degenerate(scan, update)))
    return samples


def trained(samples: Samples) -> torch.nn.Module:
    torch.manual_seed(1)
    network = torch.nn.Sequential(
        torch.nn.Conv2d(1, 8, 5, stride=4), torch.nn.ReLU(), torch.nn.Flatten(), torch.nn.Linear(8 * 7 * 7, 1)
    )
    images = torch.stack([image for image, _ in samples])
    labels = torch.tensor([[label] for _, label in samples])
    optimizer = torch.optim.Adam(network.parameters(), lr=1e-3)
    for _ in range(60):
        optimizer.zero_grad()
        torch.nn.functional.binary_cross_entropy_with_logits(network(images), labels).backward()
        optimizer.step()
    return network.eval()


if __name__ == "__main__":
    torch.set_num_threads(1)
    network = trained(samples_of("s1") + samples_of("random:office:3"))

    def degree(swarm: ddtool.Swarm) -> float:
        with torch.no_grad():
            return float(torch.sigmoid(network(image_of(swarm)[None])))

    scans = ddtool.simulate("s2", settings={"lidar.preset": "rplidar-a1"})
    slam = ddtool.Slam(particles=30, seed=1, detector=degree)
    path = slam.run(scans)
    errors_m = ddtool.score(path, scans.truth()).errors_m
    print(f"ATE {np.sqrt(np.mean(errors_m**2)):.3f} m")
