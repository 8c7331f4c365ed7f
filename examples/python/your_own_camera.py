"""A camera of your own, beside ours: each column of its image has an eye of its own, on a line from left to right."""

import numpy
from _picture import pyplot, save, show

import ocelli

SIZE = (240, 160)
EYE_DISTANCE = 10  # display radii: where the default view is


class CrossedSlits:
    """Rays through two lines: one from left to right where the eye is, and an upright one behind the scene.

    What stands in front hides less of what is behind it, as the eye looks past it from both sides.
    """

    name = "crossed slits"

    def __init__(self, baseline):
        self.baseline = baseline  # of the line of eyes, display radii

    def rays(self, width, height):
        half = numpy.tan(numpy.radians(ocelli.View().fov_vertical_degrees / 2)) * EYE_DISTANCE  # of the picture at the origin
        x = numpy.linspace(-half, half, width) * width / height
        y = numpy.linspace(half, -half, height)
        picture = numpy.stack([*numpy.meshgrid(x, y), numpy.zeros((height, width))], axis=-1)
        eyes = numpy.zeros_like(picture)
        eyes[..., 0] = numpy.linspace(-self.baseline / 2, self.baseline / 2, width)
        eyes[..., 2] = EYE_DISTANCE
        return eyes, picture - eyes


statues = ocelli.scene.load("builtin:statues")
cameras = ["di", CrossedSlits(1.6), CrossedSlits(-1.6), "ddoc", "cell"]
rows = ocelli.evaluate(statues, cameras, size=SIZE, interior_views=4, compare_images=False, runs=1)
figure, axes = pyplot.subplots(1, 4, figsize=(13, 3), width_ratios=[1, 1, 1, 1.2])
for place, camera, title in zip(axes, cameras, ["a pinhole", "eyes go along", "eyes go against"], strict=False):
    image = ocelli.render(statues, camera, size=(720, 480))
    show(place, image.color[170:390, 210:510], title)
names = ["pinhole", "along", "against", "ddoc", "cell"]
missing = [100 * row["missing_strict"]["edges"] for row in rows]
for name, percent in zip(names, missing, strict=True):
    print(f"{name:8} {percent:.2f} % missing")
axes[3].barh(names, missing)
axes[3].invert_yaxis()
axes[3].set_xlabel("missing around, % of the pixels")
figure.tight_layout()
save(figure, "your_own_camera")
