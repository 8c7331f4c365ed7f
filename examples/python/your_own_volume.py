"""A volume of your own numbers, an orbital of an atom: along the rays of two cameras, as a surface, and on a display."""

import numpy
from _picture import pyplot, save, show

import ocelli

k, j, i = numpy.meshgrid(*[numpy.linspace(-1, 1, 96, dtype=numpy.float32)] * 3, indexing="ij")
radius = numpy.sqrt(i * i + j * j + k * k)
orbital = (3 * j * j - radius**2) * numpy.exp(-8 * radius)  # positive lobes along y, a negative ring around them
field = orbital / numpy.abs(orbital).max()

colors = {
    "values": "absolute",
    "opacity_length": 0.2,
    "points": [
        {"value": -0.6, "color": "#4060ff", "opacity": 0.7},
        {"value": -0.05, "color": "#4060ff", "opacity": 0},
        {"value": 0.05, "color": "#ffb040", "opacity": 0},
        {"value": 0.6, "color": "#ffb040", "opacity": 0.7},
    ],
}
volume = ocelli.volume(field, spacing=[2 / 95] * 3, origin=[-1] * 3, transfer=colors, shaded=True)
assert numpy.shares_memory(volume.array, field)  # nothing was copied

view = ocelli.View(eye=(5, 3.5, 8), target=(0, 0, 0))
white = (1, 1, 1)
lobes = ocelli.isosurface(volume, 0.2)
seen = ocelli.observe(ocelli.slice(volume, "perspecta", light_gain=2), size=(400, 400))

figure, axes = pyplot.subplots(1, 4, figsize=(16, 4))
show(axes[0], ocelli.render(volume, view=view, size=(400, 400)).before(white), "along the rays of a pinhole")
inside = ocelli.View(eye=(0, 0, 0.01), target=(0, 0, 0), fov_vertical_degrees=90)
show(axes[1], ocelli.render(volume, "panorama", view=inside, size=(400, 400)).before(white), "all around, from inside")
show(axes[2], ocelli.render(lobes, view=view, size=(400, 400)).color, f"the surface at 0.2: {len(lobes)} triangles")
show(axes[3], seen.clip(0, 1), "on a swept-screen display")
save(figure, "your_own_volume")
