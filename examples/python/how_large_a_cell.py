"""How the errors of two cameras grow with the size of the viewpoints' cell."""

from _picture import pyplot, save

import ocelli

scene = ocelli.scene.load("builtin:statues")
sides = [0.4, 0.8, 1.2, 1.6]
figure, axes = pyplot.subplots(figsize=(7, 4))
for name, mark in [("di", "o"), ("cell", "s")]:
    missing = [
        100
        * ocelli.evaluate(
            scene, [name], cell_side=side, size=(180, 120), interior_views=2, runs=1, compare_images=False
        )[0]["missing_strict"]["edges"]
        for side in sides
    ]
    axes.plot(sides, missing, mark + "-", label=name)
axes.set_xlabel("side of the cell, display radii")
axes.set_ylabel("missing, % of the pixels")
axes.legend()
save(figure, "how_large_a_cell")
