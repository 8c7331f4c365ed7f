"""Which representation of a scene misses least, over the viewpoints of a cell: a table and a chart."""

import pandas
from _picture import pyplot, save

import ocelli

rows = ocelli.evaluate("builtin:statues", ["di", "spoc", "ddoc", "eoc-hv", "cell"], size=(240, 160), interior_views=4, runs=1)
table = pandas.json_normalize(rows).set_index("name")
print(table[["samples", "triangles", "missing_strict.edges"]])
figure, axes = pyplot.subplots(figsize=(7, 4))
axes.bar(table.index, 100 * table["missing_strict.edges"])
axes.set_ylabel("missing, % of the pixels")
axes.set_title("statues, from the edges of an 8 inch cell")
save(figure, "compare_representations")
