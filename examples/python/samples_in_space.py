"""Where the samples of an occlusion camera lie that the pinhole does not have: points in space."""

import numpy
from _picture import pyplot, save

import ocelli

statues = ocelli.scene.load("builtin:statues")
image = ocelli.render(statues, "eoc-h", size=(240, 160))
points = image.points()[image.held == 1]
moved = numpy.linalg.norm(image.displacement[image.held == 1], axis=1) > 1  # pixels
figure = pyplot.figure(figsize=(8, 6))
axes = figure.add_subplot(projection="3d")
for chosen, color, label in [(~moved, "#9a9a9a", "where the pinhole has them"), (moved, "#0072b2", "displaced")]:
    x, y, z = points[chosen][::2].T
    axes.scatter(x, -z, y, s=1, c=color, label=label)
axes.legend(markerscale=8)
axes.view_init(35, -120)
save(figure, "samples_in_space")
