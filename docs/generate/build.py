# SPDX-License-Identifier: Apache-2.0
"""Builds the documentation: pages, pictures and tables into FOLDER/pages, the site into FOLDER/site.

build.py [FOLDER]; FOLDER is build/docs. Nothing in it depends on the day or the place: two builds give the same bytes.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import clauses
import figures
import formal
import pages
import pictures
import readings
import results
from formulas import formulas
from tree import ROOT

# The page to try toolcomp, where `./dev playground` has built it.
TRY = ROOT / "build/playground/try"


def try_it(_=None):
    if TRY.is_dir():
        return '<p><a class="md-button" href="try/index.html">Try it</a></p>'
    return "This site was built without the page: `./dev playground` builds it."


# <!-- generate: NAME ARGUMENT --> in a page is replaced by what NAME says of ARGUMENT.
GENERATORS = {
    "clauses": clauses.listing,
    "open-points": clauses.open_points,
    "alarms": clauses.alarms,
    "variations": clauses.variations,
    "definition": formal.definition,
    "definitions": formal.definitions,
    "function": formal.function,
    "theorems": formal.theorems,
    "picture": pictures.picture,
    "readings-keys": readings.keys,
    "readings-parameters": readings.parameters,
    "results-details": results.details,
    "results-names": results.names,
    "results-table": results.table,
    "worked": pictures.worked,
    "counted": figures.counted,
    "sections": figures.sections,
    "table": figures.table,
    "try": try_it,
    "versions": figures.versions,
    "wrong-clauses": figures.wrong_clauses,
}


def generated(text):
    return re.sub(r"^<!-- generate: (\S+) ?(.*?) ?-->$", lambda m: GENERATORS[m[1]](m[2]), text, flags=re.M)


def write_pages(folder):
    """All pages of the navigation, and those they lead to."""
    links = pages.Links()
    parts = pages.navigation()
    for _, listed in parts:
        for file, _ in listed:
            links.page(file)
    known = len(links.pages)
    written = 0
    while written < len(links.pages):
        file = links.pages[written]
        text = links.rewrite(file, pages.commonmark((ROOT / file).read_text()))
        pages.write(folder, file, formulas(generated(text)))
        written += 1
    for figure in sorted(links.figures):
        there = folder / pages.place(figure)
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / figure, there)
    if links.faults:
        sys.exit("\n".join(links.faults))
    others = sorted(links.pages[known:])
    if others:
        parts.append(("Source tree", [(file, pages.title(file)) for file in others]))
    return parts


def write_configuration(folder, parts):
    nav = [{part: [{name: pages.place(file)} for file, name in listed]} for part, listed in parts]
    settings = {"INHERIT": str(ROOT / "docs/mkdocs.yml"), "docs_dir": str(folder / "pages"), "site_dir": str(folder / "site"),
                "theme": {"custom_dir": str(ROOT / "docs/theme")}, "nav": nav}
    # JSON is YAML.
    (folder / "mkdocs.yml").write_text(json.dumps(settings, indent=1))


def offline_search(site):
    """Index and worker of the search as scripts, which a page opened from disk may load."""
    index = site / "search/search_index.json"
    (site / "search/index.js").write_text("var __search_index = " + index.read_text().strip() + ";\n")
    index.unlink()
    worker = next((site / "assets/javascripts/workers").glob("search.*.min.js")).read_text()
    worker = re.sub(r"\n//# sourceMappingURL=.*", "", worker)
    (site / "search/worker.js").write_text("var __search_worker = " + json.dumps(worker) + ";\n")


def tidy(site):
    """What nobody needs who reads: maps of scripts, languages, the sitemap with its date."""
    for left in [*site.glob("assets/**/*.map"), *site.glob("sitemap.xml*")]:
        left.unlink()
    shutil.rmtree(site / "assets/javascripts/lunr", ignore_errors=True)
    for file in site.glob("assets/**/*.min.*"):
        text = file.read_text()
        file.write_text(re.sub(r"\n?(//# sourceMappingURL=\S+|/\*# sourceMappingURL=\S+ \*/)\n?$", "\n", text))


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/docs").resolve()
    shutil.rmtree(folder / "pages", ignore_errors=True)
    (folder / "pages/style").mkdir(parents=True)
    for file in (ROOT / "docs/style").iterdir():
        shutil.copyfile(file, folder / "pages/style" / file.name)
    (folder / "pages/style/pictures.css").write_text(pictures.style())
    write_configuration(folder, write_pages(folder / "pages"))
    environment = {**os.environ, "SOURCE_DATE_EPOCH": os.environ.get("SOURCE_DATE_EPOCH", "0"), "PYTHONHASHSEED": "0"}
    subprocess.run(["/usr/bin/mkdocs", "build", "--quiet", "--strict", "--clean", "-f", str(folder / "mkdocs.yml")],
                   check=True, env=environment)
    offline_search(folder / "site")
    tidy(folder / "site")
    if TRY.is_dir():
        shutil.copytree(TRY, folder / "site/try", dirs_exist_ok=True)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as fault:
        sys.exit(f"{fault}\n{fault.stderr or ''}")
