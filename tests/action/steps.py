#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The run: steps of action.yml, one by one, as GitHub's runner calls bash. steps.py SOURCE TOOLCOMP

The command is the one that was built; ./dev, which would build it, is a stand-in that notes how it was called. What other
actions do (uses:) is not run: that each names a version and has its files is looked up. Expected values are by hand.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

SOURCE, TOOLCOMP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
ACTION = yaml.safe_load((SOURCE / "action.yml").read_text())
STEPS = ACTION["runs"]["steps"]
DEV = f"""#!/bin/bash
cd "$(dirname "${{BASH_SOURCE[0]}}")"
printf '%s\\n' "$@" >called
mkdir -p build/release
ln -sf {TOOLCOMP} build/release/toolcomp
"""
# Answers every case with one length too long.
LIAR = """import json, sys
for request in map(json.loads, sys.stdin):
    if "hello" in request:
        answer = {"name": "liar", "version": "1", "protocol": 1, "sections": ["fanuc/tool-offset"], "fields": ["kind", "line", "axes"]}
    else:
        answer = {"id": request["id"], "events": [{"kind": "move", "line": 1, "axes": {a: 0.5 for a in request["setup"]["axes"]}}]}
    print(json.dumps(answer), flush=True)
"""


class Runner:
    """What the steps find: a workspace, the action's checkout, and what earlier steps have put out."""

    def __init__(self, folder, **inputs):
        self.folder = pathlib.Path(folder)
        self.inputs = {name: of.get("default", "") for name, of in ACTION["inputs"].items()} | inputs
        self.outputs, self.failed, self.said = {}, None, ""
        for name in ("workspace", "action", "temp"):
            (self.folder / name).mkdir()
        self.write_dev(self.folder / "action")

    @staticmethod
    def write_dev(folder):
        (folder / "dev").write_text(DEV)
        (folder / "dev").chmod(0o755)

    def value(self, text):
        """A text with its expressions."""
        def of(match):
            words = match[1].strip()
            if step := re.fullmatch(r"steps\.(\w+)\.outputs\.([\w-]+)", words):
                return self.outputs.get(step[1], {}).get(step[2], "")
            if name := re.fullmatch(r"inputs\.([\w-]+)", words):
                return self.inputs[name[1]]
            return {"github.server_url": f"file://{self.folder}", "github.action_repository": "somebody/toolcomp",
                    "github.run_id": "1", "github.run_attempt": "1"}[words]

        return re.sub(r"\$\{\{(.*?)\}\}", of, text)

    def run(self):
        """All steps with run:, to the first that fails."""
        for step in STEPS:
            if "run" not in step:
                continue
            output, summary = self.folder / "output", self.folder / "summary"
            output.write_text("")
            script = self.folder / "step.sh"
            script.write_text(step["run"])
            environment = {**os.environ, **{name: self.value(text) for name, text in step.get("env", {}).items()},
                           "GITHUB_ACTION_PATH": str(self.folder / "action"), "GITHUB_WORKSPACE": str(self.folder / "workspace"),
                           "RUNNER_TEMP": str(self.folder / "temp"), "GITHUB_OUTPUT": str(output), "GITHUB_STEP_SUMMARY": str(summary)}
            done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", str(script)], env=environment, check=False,
                                  cwd=self.folder / "workspace", capture_output=True, text=True, timeout=300)
            self.said += done.stdout + done.stderr
            self.outputs[step.get("id", step["name"])] = dict(line.split("=", 1) for line in output.read_text().splitlines())
            if done.returncode != 0:
                self.failed = step["name"]
                return self
        return self

    def called(self, where="action"):
        return (self.folder / where / "called").read_text().splitlines()

    def report(self, name):
        return (self.folder / "temp/toolcomp-report" / name).read_text()


class Steps(unittest.TestCase):
    def runner(self, **inputs):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        runner = Runner(folder.name, **inputs)
        (runner.folder / "workspace/liar.py").write_text(LIAR)
        return runner

    def test_one_that_conforms(self):
        command = f"python3 {SOURCE}/adapters/examples/controller.py"
        runner = self.runner(command=command, sections="fanuc/tool-length-offset", cases="3").run()
        self.assertIsNone(runner.failed, runner.said)
        self.assertEqual(runner.called(), ["certify", "--controller", command, "--packages"])
        self.assertEqual(json.loads(runner.report("badge.json"))["message"], "conforms in 1 of 13 sections")
        self.assertEqual(json.loads(runner.report("certificate.json"))["exit_status"], 0)
        self.assertEqual(json.loads(runner.report("certificate.sarif"))["version"], "2.1.0")
        report = runner.folder / "temp/toolcomp-report"
        self.assertEqual(runner.outputs["certify"], {
            "status": "0", "message": "conforms in 1 of 13 sections", "report": str(report), "badge": str(report / "badge.json"),
            "sarif": str(report / "certificate.sarif")})
        self.assertTrue((runner.folder / "summary").read_text().startswith("### toolcomp: conforms in 1 of 13 sections\n"))

    def test_sections_are_several_words_in_the_workspace(self):
        sections = "fanuc/tool-offset\n  fanuc/tool-length-offset"
        runner = self.runner(command="python3 liar.py", sections=sections, cases="1", **{"fail-on-finding": "false"}).run()
        self.assertIsNone(runner.failed, runner.said)
        seen = [section["section"] for section in json.loads(runner.report("certificate.json"))["sections"]]
        self.assertEqual(sorted(seen), ["fanuc/tool-length-offset", "fanuc/tool-offset"])
        self.assertEqual(runner.outputs["certify"]["status"], "1")
        self.assertIn("::warning::toolcomp: ", runner.said)
        self.assertEqual(json.loads(runner.report("badge.json"))["color"], "red")

    def test_findings_fail_the_job_behind_the_uploads(self):
        runner = self.runner(command="python3 liar.py", sections="fanuc/tool-offset", cases="1").run()
        self.assertEqual(runner.failed, "Verdict")
        self.assertRegex(runner.said, r"::error::toolcomp: \d+ findings? \(exit status 1\)")
        self.assertTrue(json.loads(runner.report("certificate.sarif"))["runs"][0]["results"])
        self.assertEqual(STEPS[-1]["name"], "Verdict")

    def test_what_is_not_decided_is_no_pass(self):
        # No section that the controller has.
        runner = self.runner(command="python3 liar.py", sections="heidenhain/face-milling", cases="1").run()
        self.assertEqual((runner.failed, runner.outputs["certify"]["status"]), ("Verdict", "3"))
        self.assertIn("nothing judged", runner.said)

    def test_bad_usage_always_fails_and_uploads_nothing(self):
        runner = self.runner(command="python3 liar.py", sections="fanuc/tool-ofset", cases="1", **{"fail-on-finding": "false"}).run()
        self.assertEqual((runner.failed, runner.outputs["certify"]["status"]), ("Verdict", "2"))
        self.assertNotIn("sarif", runner.outputs["certify"])
        self.assertEqual(runner.outputs["certify"]["message"], "no certificate")

    def test_words_of_inputs_are_no_commands(self):
        runner = self.runner(command="python3 liar.py", sections="$(touch${IFS}harm) `touch harm` *", cases="1").run()
        self.assertEqual(runner.outputs["certify"]["status"], "2")
        self.assertFalse((runner.folder / "workspace/harm").exists())

    def test_a_version_is_fetched(self):
        runner = self.runner(command="python3 liar.py", sections="fanuc/tool-offset", cases="1", version="v9", **{"fail-on-finding": "false"})
        there = runner.folder / "somebody/toolcomp"
        there.mkdir(parents=True)
        runner.write_dev(there)

        def git(*words):
            subprocess.run(["git", "-C", there, "-c", "user.name=t", "-c", "user.email=t@localhost", *words], check=True, capture_output=True)

        git("init", "-q")
        git("add", "dev")
        git("commit", "-q", "-m", "one")
        git("tag", "v9")
        runner.run()
        self.assertIsNone(runner.failed, runner.said)
        self.assertEqual(runner.called("temp/toolcomp-source")[0], "certify")
        self.assertFalse((runner.folder / "action/called").exists())

    def test_a_version_that_is_not_there_fails(self):
        runner = self.runner(command="python3 liar.py", version="v0").run()
        self.assertEqual(runner.failed, "Find toolcomp")


class Form(unittest.TestCase):
    def test_steps_name_their_shell_and_others_their_version(self):
        for step in STEPS:
            if "run" in step:
                self.assertEqual(step["shell"], "bash", step["name"])
                self.assertNotIn("${{", step["run"], f"{step['name']}: text of inputs belongs into env")
            else:
                self.assertRegex(step["uses"], r"^[\w-]+/[\w/-]+@v\d+$")

    def test_expressions_name_what_there_is(self):
        ids = {step["id"] for step in STEPS if "id" in step}
        text = (SOURCE / "action.yml").read_text()
        for name in re.findall(r"inputs\.([\w-]+)", text):
            self.assertIn(name, ACTION["inputs"])
        for step, output in re.findall(r"steps\.(\w+)\.outputs\.([\w-]+)", text):
            self.assertIn(step, ids)
            self.assertIn(f"{output}=", next(s for s in STEPS if s.get("id") == step)["run"])

    def test_the_page_names_every_input_and_output(self):
        page = (SOURCE / "docs/action.md").read_text()
        for name in [*ACTION["inputs"], *ACTION["outputs"]]:
            self.assertIn(f"| `{name}` |", page)

    def test_workflows_and_forms_are_yaml(self):
        files = sorted((SOURCE / ".github").rglob("*.yml"))
        self.assertGreater(len(files), 4)
        for file in files:
            self.assertIsInstance(yaml.safe_load(file.read_text()), dict, file)

    def test_forms_of_issues_have_what_github_asks_for(self):
        # https://docs.github.com/en/communities/using-templates-to-encourage-useful-issues-and-pull-requests/syntax-for-githubs-form-schema
        kinds = {"markdown", "input", "textarea", "dropdown", "checkboxes"}
        for file in (SOURCE / ".github/ISSUE_TEMPLATE").glob("*.yml"):
            form = yaml.safe_load(file.read_text())
            if file.name == "config.yml":
                self.assertIsInstance(form["blank_issues_enabled"], bool)
                continue
            self.assertTrue(form["name"] and form["description"])
            ids = [field["id"] for field in form["body"] if field["type"] != "markdown"]
            self.assertEqual(len(ids), len(set(ids)))
            for field in form["body"]:
                self.assertIn(field["type"], kinds)
                self.assertTrue(field["attributes"].get("value" if field["type"] == "markdown" else "label"), file)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
