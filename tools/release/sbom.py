# SPDX-License-Identifier: MIT
"""What a release consists of, as SPDX 2.3: every file of the add-on's zip with its checksums, and what is linked into each library."""

import hashlib
import json
import pathlib
import re
import subprocess
import time
from dataclasses import dataclass

from tools.build import toolchains, universal, zig
from tools.fetch import machine
from tools.places import ROOT
from tools.say import Failure

OWN = "MIT"  # the licence of the project's own files
OWNER = re.search(r"Copyright \(c\) .*", (ROOT / "LICENSE").read_text())[0]
NOTHING = "NOASSERTION"


@dataclass(frozen=True)
class Part:
	"""Something of others that is in a library."""

	name: str
	version: str
	licence: str
	owner: str

	@property
	def key(self):
		return f"SPDXRef-{re.sub(r'[^A-Za-z0-9.]+', '-', f'{self.name}-{self.version}')}"


def said(*command):
	result = subprocess.run(command, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"{command[0]} does not tell its version: {result.stderr.strip()}")
	return result.stdout.strip()


def eigen():
	headers = [
		pathlib.Path(machine.eigen()) / file for file in ("Eigen/Version", "Eigen/src/Core/util/Macros.h")
	]  # of newer ones, older ones
	text = next(header for header in headers if header.exists()).read_text()
	world, major, minor, patch = (
		(re.findall(rf"define EIGEN_{name}_VERSION (\d+)", text) or ["0"])[0] for name in ("WORLD", "MAJOR", "MINOR", "PATCH")
	)
	version = f"{major}.{minor}.{patch}" if int(major) >= 5 else f"{world}.{major}.{minor}"  # since 5 it counts without its world
	return Part("Eigen", version, "MPL-2.0", "Eigen contributors")


def runtimes(target):
	"""Returns the parts of a compiler that are linked into a library."""
	if zig.is_for(target.system, target.arch) or universal.is_ours(target.system, target.arch):
		pinned = re.search(r"^ziglang==(\S+)", (ROOT / "tools/build/zig_requirements.txt").read_text(), re.MULTILINE)[1]
		runtime = Part("libc++ of zig", pinned, "Apache-2.0 WITH LLVM-exception", "LLVM contributors")
		return [runtime, *([Part("MinGW-w64 of zig", pinned, "ZPL-2.1", "mingw-w64 project")] if target.system == "windows" else [])]
	if target.system in ("web", "macos"):  # the engine's main module has them, or the system
		return []
	compiler = toolchains.compiler(target.system, target.arch).split()[-1]
	version = said(compiler, "-dumpversion" if toolchains.is_clang(compiler) else "-dumpfullversion")
	name = "libstdc++, libgcc and libatomic" if target.arch == "rv64" else "libstdc++ and libgcc"
	runtime = Part(name, version, "GPL-3.0-or-later WITH GCC-exception-3.1", "Free Software Foundation, Inc.")
	if target.system != "windows":
		return [runtime]
	header = subprocess.run(
		[compiler, "-E", "-P", "-xc++", "-"], input="#include <_mingw.h>\n__MINGW64_VERSION_STR", capture_output=True, text=True
	)
	version = "".join(re.findall(r'"([\d.]+)"', header.stdout.splitlines()[-1]))  # a text for each of its parts
	return [runtime, Part("MinGW-w64", version, "ZPL-2.1 AND MIT", "mingw-w64 project")]


def together(licences):
	return " AND ".join(sorted({part for licence in licences for part in licence.split(" AND ")}))


def entry(name, data, parts):
	"""Returns a file of the zip."""
	return {
		"SPDXID": f"SPDXRef-File-{hashlib.sha256(name.encode()).hexdigest()[:16]}",
		"fileName": f"./{name}",
		"checksums": [
			{"algorithm": "SHA1", "checksumValue": hashlib.sha1(data).hexdigest()},
			{"algorithm": "SHA256", "checksumValue": hashlib.sha256(data).hexdigest()},
		],
		"licenseConcluded": together([OWN, *(part.licence for part in parts)]),
		"licenseInfoInFiles": [NOTHING],
		"copyrightText": OWNER,
	}


def addon(name, version, archive, files):
	"""Returns the package of the add-on itself. `archive`: the zip's bytes; `files`: its entries."""
	sums = sorted(file["checksums"][0]["checksumValue"] for file in files)
	return {
		"SPDXID": "SPDXRef-GrassField",
		"name": "GrassField",
		"versionInfo": version,
		"packageFileName": name,
		"primaryPackagePurpose": "LIBRARY",
		"downloadLocation": NOTHING,
		"filesAnalyzed": True,
		"packageVerificationCode": {"packageVerificationCodeValue": hashlib.sha1("".join(sums).encode()).hexdigest()},
		"checksums": [{"algorithm": "SHA256", "checksumValue": hashlib.sha256(archive).hexdigest()}],
		"licenseConcluded": together(file["licenseConcluded"] for file in files),
		"licenseDeclared": OWN,
		"licenseInfoFromFiles": [NOTHING],
		"copyrightText": OWNER,
	}


def part_entry(part):
	return {
		"SPDXID": part.key,
		"name": part.name,
		"versionInfo": part.version,
		"downloadLocation": NOTHING,
		"filesAnalyzed": False,
		"licenseConcluded": part.licence,
		"licenseDeclared": part.licence,
		"copyrightText": part.owner,
	}


def text(version, archive, files, targets, seconds):
	"""The document. `archive`: path of the add-on's zip; `files`: path -> bytes of what is in it; `targets`: whose libraries these are;
	`seconds`: the commit's time."""
	linked = {target.library: [eigen(), *runtimes(target)] for target in targets}
	entries = {name: entry(name, data, linked.get(pathlib.PurePosixPath(name).name, [])) for name, data in sorted(files.items())}
	parts = sorted({part for parts in linked.values() for part in parts}, key=lambda part: part.key)
	data = archive.read_bytes()
	relations = [("SPDXRef-DOCUMENT", "DESCRIBES", "SPDXRef-GrassField")]
	relations += [("SPDXRef-GrassField", "CONTAINS", file["SPDXID"]) for file in entries.values()]
	for name, file in entries.items():
		relations += [(file["SPDXID"], "STATIC_LINK", part.key) for part in linked.get(pathlib.PurePosixPath(name).name, [])]
	document = {
		"spdxVersion": "SPDX-2.3",
		"dataLicense": "CC0-1.0",
		"SPDXID": "SPDXRef-DOCUMENT",
		"name": archive.stem,
		"documentNamespace": f"https://spdx.org/spdxdocs/{archive.stem}-{hashlib.sha256(data).hexdigest()}",
		"creationInfo": {
			"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)),
			"creators": ["Organization: GrassField contributors", "Tool: grass-release"],
		},
		"packages": [addon(archive.name, version, data, list(entries.values())), *map(part_entry, parts)],
		"files": list(entries.values()),
		"relationships": [{"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other} for one, kind, other in relations],
	}
	return json.dumps(document, indent="\t", ensure_ascii=False) + "\n"
