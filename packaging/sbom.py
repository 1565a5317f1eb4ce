# SPDX-License-Identifier: Apache-2.0
"""The bill of materials of the packages in FOLDER, as SPDX 2.3 (JSON), into FOLDER/sbom.spdx.json.

What each package depends on is read from the packages; of what was linked in, the versions are those of the machine
that built them (the .buildinfo beside the packages). The same packages give the same bytes.
"""

import hashlib
import json
import pathlib
import re
import subprocess
import sys

FIELDS = ("Package", "Version", "Architecture", "Depends")
# Headers and static libraries that become part of ours; the rest of a build's packages are tools.
LINKED = ("libeigen3-dev", "libboost1.74-dev", "nlohmann-json3-dev", "libcli11-dev", "pybind11-dev", "libjs-three",
          "ocaml-nox", "libgmp-dev", "libmpfr-dev", "libmpfi-dev", "libflint-arb-dev", "libflint-dev", "libfmt-dev",
          "libtomlplusplus-dev", "nettle-dev", "libarchive-dev")  # fmt: skip


def field(package, name):
    return subprocess.run(["dpkg-deb", "-f", package, name], check=True, capture_output=True, text=True).stdout.strip()


def identifier(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.]", "-", name)


def built_with(folder):
    """The packages of the machine that built these, with their versions."""
    text = next(folder.glob("*.buildinfo")).read_text()
    listed = re.search(r"^Installed-Build-Depends:\n((?: .*\n)+)", text, re.M)[1]
    return dict(re.findall(r"^ (\S+) \(= ([^)]*)\)", listed, re.M))


def main():
    folder = pathlib.Path(sys.argv[1])
    packages, relations, seen = [], [], set()

    def other(name, version):
        """A package of Debian."""
        if name not in seen:
            seen.add(name)
            entry = {"SPDXID": identifier(name), "name": name, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                     "supplier": "Organization: Debian"}
            if version:
                entry["versionInfo"] = version
                entry["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                          "referenceLocator": f"pkg:deb/debian/{name}@{version}"}]
            packages.append(entry)
        return identifier(name)

    built = built_with(folder)
    debs = sorted(folder.glob("*.deb"))
    ours = {}
    for deb in debs:
        ours[deb] = {name: field(deb, name) for name in FIELDS}
    names = {about["Package"] for about in ours.values()}
    for deb, about in ours.items():
        mine = identifier(about["Package"])
        packages.append({
            "SPDXID": mine, "name": about["Package"], "versionInfo": about["Version"], "packageFileName": deb.name,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseDeclared": "Apache-2.0",
            "licenseConcluded": "Apache-2.0", "copyrightText": "2026 The toolcomp authors",
            "checksums": [{"algorithm": "SHA256", "checksumValue": hashlib.sha256(deb.read_bytes()).hexdigest()}]})
        relations.append(("SPDXRef-DOCUMENT", "DESCRIBES", mine))
        for name in re.findall(r"(?:^|, )([a-z0-9][a-z0-9.+-]*)", about["Depends"]):
            there = identifier(name) if name in names else other(name, built.get(name, ""))
            relations.append((mine, "DEPENDS_ON", there))
        if about["Architecture"] != "all":
            for name in LINKED:
                if name in built:
                    relations.append((other(name, built[name]), "BUILD_DEPENDENCY_OF", mine))
    digest = hashlib.sha256("".join(p["checksums"][0]["checksumValue"] for p in packages if "checksums" in p).encode())
    epoch = field(debs[0], "Version")
    made = subprocess.run(["dpkg-parsechangelog", "-S", "Timestamp"], check=True, capture_output=True, text=True).stdout
    created = subprocess.run(["date", "-u", "-d", "@" + made.strip(), "+%Y-%m-%dT%H:%M:%SZ"], check=True,
                             capture_output=True, text=True).stdout.strip()
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"toolcomp-{epoch}",
        "documentNamespace": f"https://spdx.org/spdxdocs/toolcomp-{epoch}-{digest.hexdigest()[:32]}",
        "creationInfo": {"created": created, "creators": ["Tool: toolcomp packaging"]}, "packages": packages,
        "relationships": [{"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
                          for a, kind, b in relations]}  # fmt: skip
    (folder / "sbom.spdx.json").write_text(json.dumps(document, indent=1) + "\n")


if __name__ == "__main__":
    main()
