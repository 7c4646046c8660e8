"""The programs in docs/python.md run as they stand there, one after the other."""

from pathlib import Path

import duckdb

DOCS = Path(__file__).parents[3] / "docs" / "python.md"


def test_the_programs_of_the_document_run(capsys):
    blocks = [block.split("```")[0] for block in DOCS.read_text().split("```python\n")[1:]]
    names = {}
    for block in blocks:
        exec(compile(block, str(DOCS), "exec"), names)
    printed = capsys.readouterr().out
    assert "/sinkage_mm unknown field; `sinkage_m` is in m: 1 mm is 0.001 m" in printed
    forces = names["forces"]  # by now the function of the last program
    assert callable(forces) and names["found"].slip.dims == ("slope", "mass")
    # The function of SQL has the numbers of a request.
    rows = names["database"].sql("SELECT unnest(forces(0.2, 80.0))").fetchall()
    alone = names["terramechanics"].ask("forces", {**names["REQUEST"], "slip": 0.2, "normal_load_n": 80})
    assert rows == [(*(alone[name] for name in names["WANTED"]), "ok")]
    assert isinstance(names["database"], duckdb.DuckDBPyConnection)
    # The other engine finds the same of the same points.
    best = {row["load"]: (row["best"], row["answered"]) for row in names["best"].to_pylist()}
    for load in (40.0, 80.0):
        slips = [slip / 100 for slip in range(1, 61)]
        forces = names["terramechanics"].batch({"slip": slips}, {**names["REQUEST"], "normal_load_n": load})["longitudinal_force_n"]
        assert best[load] == (forces.max(), 60)
