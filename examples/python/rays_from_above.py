"""How cameras look: the rays of one row of pixels, from above."""

import numpy
from _picture import pyplot, save

import ocelli

SIZE = (96, 64)


def draw(axes, rays, title, row, reach):
    """Every second ray of a row, where it is within `reach` of the origin."""
    for x in range(0, rays.width, 2):
        points, t = rays.ray(x, row)
        if not len(t):
            continue
        # Rays are long: many points on the piece that is shown.
        fine = numpy.linspace(t[0], min(t[-1], t[0] + 6 * reach), 600)
        line = numpy.stack([numpy.interp(fine, t, points[:, axis]) for axis in (0, 2)])
        line[:, (numpy.abs(line) > reach).any(axis=0)] = numpy.nan
        axes.plot(*line, color=pyplot.cm.viridis(x / rays.width), linewidth=0.7)
    axes.set_title(title)
    axes.set_xlabel("x")
    axes.set_aspect("equal")
    axes.invert_yaxis()


torus = ocelli.scene.load("builtin:torus")
maze = ocelli.scene.load("builtin:maze")
near = ocelli.View(eye=(0, 0, 3))
figure, axes = pyplot.subplots(1, 3, figsize=(13, 4.5))
draw(axes[0], ocelli.camera.rays("di", view=near, size=SIZE), "a pinhole", 32, 3)
draw(axes[1], ocelli.camera.rays("ddoc", scene=torus, view=near, size=SIZE), "an occlusion camera", 32, 3)
draw(axes[2], ocelli.camera.rays("comprehensive", scene=maze, size=SIZE), "a graph camera in a maze", 20, 1)
axes[0].set_ylabel("z, towards the eye")
figure.tight_layout()
save(figure, "rays_from_above")
