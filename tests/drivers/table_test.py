# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
import json
import pathlib
import tempfile
import unittest

import table


def results(**verdicts: str) -> str:
    return json.dumps({"environment": {"version": "4.6 Mesa 22.3.6"}, "results": [{"name": name.replace("_", "."), "verdict": verdict, "messages": [f"{name} differs"], "output": ""}
                                   for name, verdict in verdicts.items()]})


class Table(unittest.TestCase):
    def setUp(self) -> None:
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name) / "zink"
        self.folder.mkdir()
        (self.folder / "faults.txt").write_text("renderer: zink (x)\nversion: 4.6 Mesa 22.3.6\nrestart_quads: no: 4 of 4\n"
                                                "restart_polygon: yes: 6 triangles, expected 4\n")

    def add(self, cell: str, **verdicts: str) -> None:
        (self.folder / cell).mkdir()
        (self.folder / cell / "results.json").write_text(results(**verdicts))

    def row(self) -> table.Row:
        return table.Row(self.folder)

    def test_counts_and_failures(self) -> None:
        self.add("egl-gles", ark_a="Pass", ark_b="NotSupported", ark_c="Crash")
        self.add("glx-gl-core", ark_a="Pass", ark_c="Fail")
        self.assertEqual(self.row().title, "zink, Mesa 22.3.6")
        self.assertEqual(table.cell_text(self.row(), "egl-gles", 3), "1, **1 fail**")
        self.assertEqual(table.cell_text(self.row(), "egl-gl-core", 3), "-")
        self.assertEqual(table.cell_text(self.row(), "egl-gles", 12), "1 (1 in 4), **1 fail**")
        self.assertEqual(self.row().bad(), {"ark.c": (["egl-gles", "glx-gl-core"], "ark_c differs")})

    def test_a_line_for_each_reason(self) -> None:
        self.add("egl-gles", ark_a="Fail", ark_b="Fail", **{"ark_coarse_centroid_restart": "Fail"})
        lines = table.failures_of(self.row())
        self.assertEqual(len(lines), 3)
        self.assertIn("| zink, Mesa 22.3.6 | `ark.a` | egl-gles | not explained: ark_a differs |", lines)

    def test_only_faults_that_are_there(self) -> None:
        self.assertEqual(self.row().faults, {"restart_polygon": "6 triangles, expected 4"})

    def test_reasons(self) -> None:
        self.assertIn("restart_polygon", table.reason_of(self.row(), "ark.coarse.centroid.restart"))
        self.assertEqual(table.reason_of(self.row(), "ark.other"), "not explained")

    def test_driver_that_cannot_run(self) -> None:
        (self.folder / "faults.txt").write_text("cannot run: the package p is not installed\n")
        self.assertIn("| zink | cannot run: the package p is not installed |", table.lines_of([self.row()])[2])

    def test_version(self) -> None:
        self.assertEqual(table.version_of("OpenGL ES 3.1 (ANGLE 2.1.27278 git hash: 0d61)"), "ANGLE 2.1.27278")
        self.assertEqual(table.version_of("4.6 (Compatibility Profile) Mesa 22.3.6"), "Mesa 22.3.6")

    def test_the_system_has_the_name_of_its_card(self) -> None:
        card = self.folder.rename(self.folder.parent / table.SYSTEM)
        (card / "faults.txt").write_text("renderer: NVIDIA H100 80GB HBM3/PCIe/SSE2\nversion: 4.6.0 NVIDIA 580.159.04\n")
        self.assertEqual(table.Row(card).title, "NVIDIA H100 80GB HBM3, NVIDIA 580.159.04")

    def test_rows_of_other_machines_stay(self) -> None:
        self.add("egl-gles", ark_a="Fail")
        other = self.folder.parent / "llvmpipe"
        other.mkdir()
        (other / "faults.txt").write_text("version: 4.5 Mesa 22.3.6\nrestart_polygon: yes: 6 triangles, expected 4\n")
        (other / "egl-gles").mkdir()
        (other / "egl-gles/results.json").write_text(results(ark_b="Fail"))
        before = "\n".join(table.lines_of([table.Row(other)]))
        lines = table.lines_of([self.row()], before)
        self.assertEqual(len([line for line in lines if line.startswith("| llvmpipe, Mesa 22.3.6 |")]), 2)
        self.assertEqual(len([line for line in lines if line.startswith("| zink, Mesa 22.3.6 |")]), 2)
        self.assertIn("| `restart_polygon` | 6 triangles, expected 4 | llvmpipe, Mesa 22.3.6; zink, Mesa 22.3.6 |", lines)
        again = table.lines_of([self.row()], "\n".join(lines))
        self.assertEqual(again, lines, "a row that is made again replaces the former one")

    def test_piglit(self) -> None:
        (self.folder / "piglit.txt").write_text("| mode | same |\n| off | 10 | 10 | 100.00 |\n| outputs-2 | 9 | 10 | 90.00 |\n")
        self.assertEqual(table.piglit_text(self.row()), "off 10 of 10, outputs-2 9 of 10")

    def test_writes_between_the_marks_only(self) -> None:
        document = self.folder / "drivers.md"
        document.write_text(f"before\n{table.BEGIN}\nold\n{table.END}\nafter\n")
        self.assertEqual(table.make([self.folder.parent], document, True), 0)
        text = document.read_text()
        self.assertTrue(text.startswith(f"before\n{table.BEGIN}\n| driver |") and text.endswith(f"{table.END}\nafter\n"))
        self.assertNotIn("old", text)

    def test_needs_the_marks(self) -> None:
        document = self.folder / "drivers.md"
        document.write_text("no marks")
        with self.assertRaises(SystemExit):
            table.make([self.folder.parent], document, True)


unittest.main()
