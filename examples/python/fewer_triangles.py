"""A reference image bounds the triangles of a scene: meshes of three sizes of image."""

from _picture import pyplot, save

import ocelli

statues = ocelli.scene.load("builtin:statues")
widths = [90, 180, 360, 720]
triangles = [
    len(ocelli.ocri.mesh(ocelli.ocri.build(statues, "ddoc", size=(width, width * 2 // 3)))) for width in widths
]
figure, axes = pyplot.subplots(figsize=(7, 4))
axes.loglog(widths, triangles, "o-", label="mesh of the reference image")
axes.axhline(len(statues.mesh), color="#666", linestyle="--", label="scene")
axes.set_xlabel("width of the image, pixels")
axes.set_ylabel("triangles")
axes.legend()
save(figure, "fewer_triangles")
