"""A study from Python is that of the command."""

import csv
import json
import re
import shutil
import tomllib
from pathlib import Path

import loosepin as lp
import numpy as np
import pyarrow.compute
import pyarrow.parquet
import pytest
from conftest import STUDY, command


@pytest.mark.parametrize("file", ["summary.json", "bounds.csv", "runs.parquet", "report.html"])
def test_identity_files_are_those_of_the_command(desk, result, file):
    assert (desk / "python" / file).read_bytes() == (desk / "command" / file).read_bytes()


def test_identity_summary_is_that_of_the_command(desk, result):
    assert result.summary == json.loads((desk / "command/summary.json").read_text(encoding="utf-8"))


def test_identity_bounds_are_the_rows_of_the_table(desk, result):
    with open(desk / "command/bounds.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(result.bounds)
    for row, bound in zip(rows, result.bounds):
        assert (row["output"], row["of"], row["at"], row["statistic"]) == (bound.output, bound.of, bound.at, bound.statistic)
        assert (float(row["lower"]), float(row["upper"])) == (bound.lower.value, bound.upper.value)
        assert (float(row["lower_widened"]), float(row["upper_widened"])) == bound.widened
        assert float(row["upper_error_sampling"]) == bound.upper.error_sampling
    frame = result.to_pandas()
    assert list(frame["lower_widened"]) == [bound.lower.widened for bound in result.bounds]


def test_identity_samples_are_the_runs(desk, result):
    table = pyarrow.parquet.read_table(desk / "command/runs.parquet")
    assert list(result.samples) == table.column_names
    for name in table.column_names:
        np.testing.assert_array_equal(result.samples[name], table[name].to_numpy(), err_msg=name)
        assert result.samples.units[name].encode() == table.schema.field(name).metadata[b"unit"]
    assert json.loads(pyarrow.parquet.read_metadata(desk / "command/runs.parquet").metadata[b"units"]) == dict(result.samples.units)
    nullable = {field.name for field in table.schema if field.nullable}
    assert nullable == {field.name for field in table.schema if field.type == pyarrow.float64()}
    assert {str(field.type) for field in table.schema} == {"uint64", "double", "string"}
    assert list(result.samples.inputs) == ["parameter.crank_length", "parameter.rod_length", "joint.gudgeon.radial_clearance"]
    assert list(result.samples.outputs) == ["slider total maximum_absolute"]
    assert list(result.samples.to_pandas().columns) == table.column_names


def check_statistics(file):
    """The least and the largest value and the number of missing ones in each chunk are those of its values."""
    for group in range(file.metadata.num_row_groups):
        table = file.read_row_group(group)
        for place, name in enumerate(table.column_names):
            chunk = file.metadata.row_group(group).column(place)
            assert (chunk.compression, chunk.path_in_schema, chunk.num_values) == ("UNCOMPRESSED", name, table.num_rows)
            assert chunk.statistics.null_count == table[name].null_count
            if table[name].null_count == table.num_rows:
                continue
            ends = pyarrow.compute.min_max(table[name]).as_py()
            longest = 64
            if chunk.physical_type == "BYTE_ARRAY" and len(ends["max"].encode()) > longest:
                assert (chunk.statistics.min, chunk.statistics.max > ends["max"]) == (ends["min"], True)
            else:
                assert (chunk.statistics.min, chunk.statistics.max) == (ends["min"], ends["max"])


def test_identity_statistics_in_the_file_are_those_of_the_values(desk, result):
    file = pyarrow.parquet.ParquetFile(desk / "command/runs.parquet")
    assert file.metadata.num_row_groups == 1
    check_statistics(file)


def test_peer_a_file_of_two_row_groups_is_read_by_pyarrow():
    runs = Path(__file__).parents[2] / "loosepin-study/tests/runs"
    file = pyarrow.parquet.ParquetFile(runs / "two_groups.parquet")
    assert [file.metadata.row_group(group).num_rows for group in range(2)] == [65_536, 64]
    check_statistics(file)
    # The other one was written by the crate `parquet`.
    table, earlier = file.read(), pyarrow.parquet.read_table(runs / "earlier.parquet")
    assert table.column_names == earlier.column_names
    for name in table.column_names:
        np.testing.assert_array_equal(table[name].to_numpy(), earlier[name].to_numpy(), err_msg=name)
    assert table["index"].to_pylist() == list(range(65_600))


def test_identity_a_finished_folder_is_read_again(desk, result):
    told = []
    again = lp.Study.load(desk / "study.toml").run(desk / "command", progress=lambda *numbers: told.append(numbers))
    assert again.summary == result.summary
    np.testing.assert_array_equal(again.samples["reason"], result.samples["reason"])
    assert told == []


def test_compressed_runs_of_an_earlier_state_are_refused(desk, result, tmp_path):
    shutil.copytree(desk / "command", tmp_path / "earlier")
    runs = tmp_path / "earlier/runs.parquet"
    pyarrow.parquet.write_table(pyarrow.parquet.read_table(runs), runs, compression="zstd")
    with pytest.raises(lp.LoosepinError) as changed:
        lp.Study.load(desk / "study.toml").run(tmp_path / "earlier", progress=False)
    assert changed.value.code == "E0913"
    assert "runs.parquet is not the file that the study" in str(changed.value)
    # As if it had been written so.
    marker = tmp_path / "earlier/loosepin.json"
    marker.write_text(json.dumps(json.loads(marker.read_text()) | {"files": {"summary.json": None, "runs.parquet": None}}))
    with pytest.raises(lp.LoosepinError) as refused:
        lp.Study.load(desk / "study.toml").run(tmp_path / "earlier", progress=False)
    assert refused.value.code == "E0902"
    assert "the runs are compressed with ZSTD; this version reads only uncompressed runs" in str(refused.value)
    assert "pyarrow and pandas read the file as it is" in str(refused.value)


def test_identity_a_dict_on_more_threads_without_a_folder_is_the_file(desk, result):
    mapping = tomllib.loads(STUDY) | {"model": lp.Model.load(desk / "model.toml")}
    told = []
    again = lp.Study.from_dict(mapping).run(threads=3, progress=lambda *numbers: told.append(numbers))
    # The text is another one, and with it the hash and the files that are kept.
    own = {"input_hash": "", "repeat": None}
    assert again.summary | own == result.summary | own
    np.testing.assert_array_equal(again.samples["slider total maximum_absolute"], result.samples["slider total maximum_absolute"])
    assert told[-1] == (result.summary["counts"]["runs"],) * 2
    assert [finished for finished, _ in told] == sorted(finished for finished, _ in told)


def test_text_names_its_model_from_its_folder(desk):
    study = lp.Study.from_text(STUDY, name=str(desk / "typed.toml"))
    assert study.model.name == "slider-crank with a worn gudgeon pin"
    assert study.most_runs > 1000


def test_selection_and_requirements(result):
    [quantile] = result.select(output="slider", statistic="quantile")
    assert (quantile.parameter, quantile.reduction, quantile.unit) == (0.975, "maximum_absolute", "m")
    assert quantile.lower.widened <= quantile.lower.value <= quantile.upper.value <= quantile.upper.widened
    assert set(quantile.upper.witness) == {"joint.gudgeon.radial_clearance"}
    assert result.is_met == (result.requirements[0]["verdict"] == "met")
    assert str(quantile).startswith("slider total maximum_absolute: quantile 0.975 in [")


def test_curves(result):
    [curve] = result.curves
    dataset = result.to_xarray()
    assert dataset.sizes == {"pose_rad": len(curve.pose_rad), "end": 2}
    np.testing.assert_array_equal(dataset["slider_total_mixed"].sel(end="upper").values, curve.mixed[1])
    means = result.select(at="curve", statistic="mean", treatment="mixed")
    np.testing.assert_array_equal(dataset["slider_total_mean"].values, [bound.widened for bound in means])
    assert dataset["slider_total_mean"].attrs["units"] == "m"


@pytest.mark.parametrize("kind, label", [("curves", "slider, total [mm]"), ("box", "probability to stay below"), ("contributors", "")])
def test_figures(result, kind, label):
    figure = result.plot(kind)
    assert figure.axes[0].get_ylabel() == label
    if kind == "contributors":
        colours = {patch.get_facecolor()[:3] for patch in figure.axes[0].patches}
        assert len(colours) == 2


def test_a_figure_that_is_not_there_is_refused(result):
    with pytest.raises(ValueError, match="no curves of output='rocker'"):
        result.plot("curves", output="rocker")
    with pytest.raises(ValueError, match="must be 'curves', 'box' or 'contributors'"):
        result.plot("pie")


def test_notebook_needs_no_network(result):
    page = result._repr_html_()
    assert "a tenth of a turn" in page and "quantile" in page and "slider" in page
    # The mechanism and the chart are pictures within the page.
    page, pictures = re.subn(r'src="data:image/svg\+xml;charset=utf-8,[^"]*"', "", page)
    assert pictures == 2
    assert "<script" not in page and "http" not in page and "src=" not in page


def test_report_and_text_are_those_of_the_command(desk, result, tmp_path):
    assert result.report(tmp_path / "page.html").read_bytes() == (desk / "command/report.html").read_bytes()
    again = command("study", "study.toml", "--out", "command", cwd=desk)
    assert str(result) == again.stdout


def test_accuracy_and_budget_are_those_of_the_command(desk):
    study = lp.Study.load(desk / "study.toml")
    with pytest.raises(lp.LoosepinError) as refused:
        study.run(accuracy=["rocker=1 um"])
    ended = command("study", "study.toml", "--accuracy", "rocker=1 um", cwd=desk)
    # The command says first what looks like an oversight in the file; here that is a warning of Python.
    assert ended.stderr.strip().endswith(str(refused.value))
    with pytest.raises(lp.LoosepinError) as refused:
        study.run(budget="10 runs")
    ended = command("study", "study.toml", "--budget", "10 runs", cwd=desk)
    assert ended.stderr.strip().endswith(str(refused.value))


def test_no_threads_are_refused(desk):
    for threads in (0, -1, 10**6):
        with pytest.raises(ValueError, match=f"threads {threads}; must be between 1 and 1024"):
            lp.Study.load(desk / "study.toml").run(threads=threads)
