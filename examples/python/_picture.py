"""What the examples share: where their pictures go."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # files, not windows
import matplotlib.pyplot as pyplot  # noqa: E402 - behind the choice above


def save(figure, name):
    """Writes NAME.png into the folder that the command line names, or this one."""
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name}.png"
    figure.savefig(path, dpi=100, bbox_inches="tight")
    pyplot.close(figure)
    print("wrote", path)


def show(axes, linear, title):
    """A linear image without ticks."""
    import ocelli

    axes.imshow(ocelli.srgb(linear))
    axes.set_title(title)
    axes.axis("off")
