"""A mesh of your own numbers: a wavy sheet, seen by a pinhole and from aside of its reference image."""

import numpy
from _picture import pyplot, save, show

import ocelli

side = 120
u, v = numpy.meshgrid(numpy.linspace(-1, 1, side), numpy.linspace(-1, 1, side))
height = 0.25 * numpy.sin(6 * u) * numpy.cos(6 * v)
positions = numpy.stack([u, v, height], axis=-1).reshape(-1, 3)
colors = numpy.stack([0.5 + 0.5 * u, 0.5 + 2 * height, 0.5 + 0.5 * v], axis=-1).clip(0, 1).reshape(-1, 3)
corner = (numpy.arange(side - 1)[:, None] * side + numpy.arange(side - 1)).ravel()
triangles = numpy.concatenate(
    [numpy.stack([corner, corner + 1, corner + side], 1), numpy.stack([corner + 1, corner + side + 1, corner + side], 1)]
)
sheet = ocelli.Scene(ocelli.Mesh(positions, triangles, colors), fit=True)

images = ocelli.ocri.build(sheet, "di", size=(360, 360))
aside = ocelli.resample(images, ocelli.View(eye=(4, 2, 9)), size=(360, 360))
figure, axes = pyplot.subplots(1, 2, figsize=(9, 4.5))
show(axes[0], images[0].color, "from the front")
show(axes[1], aside.color, "its samples, from aside")
save(figure, "your_own_mesh")
