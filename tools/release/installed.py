"""Each file of a release is installed in a clean root and used as the README says."""

from collections.abc import Callable
from dataclasses import dataclass

import readme
from errors import ReleaseError
from paths import FILES, REPOSITORY, released
from roots import Answer, Root, clean_root

CASES = "cases/slider_crank_worn_pin"
MIN_PAGE_BYTES = 10_000
# The commands that write a page.
WITH_PAGE = ("motion", "simulate", "study")


@dataclass(frozen=True)
class Step:
    system: str
    what: str
    seconds: float


def require(holds: bool, what: str) -> None:
    if not holds:
        raise ReleaseError(what, "look at what was packed, and at docs/release.md")


def require_pages(root: Root, count: int) -> None:
    pages = list(root.path("/root").rglob("report.html"))
    require(len(pages) == count, f"{root.system}: {len(pages)} pages were written; must be {count}")
    for page in pages:
        require(page.stat().st_size > MIN_PAGE_BYTES, f"{root.system}: {page} has {page.stat().st_size} bytes")


def version_printed(answer: Answer, root: Root) -> None:
    package = released("loosepin_*.deb").name.split("_")[1]
    require(answer.text.startswith(f"loosepin {package}"), f"{root.system}: --version prints {answer.text.strip()}, not {package}")


def program(suite: str) -> list[Step]:
    """The archive is unpacked; every command of the README runs, without a network."""
    archive = released("loosepin-*.tar.gz")
    with clean_root(suite) as root:
        root.copy_in(archive, f"/root/{archive.name}")
        root.copy_in(REPOSITORY / CASES, f"/root/{CASES}")
        folder = archive.name.removesuffix(".tar.gz")
        unpacked = root.run(f"tar --extract --file {archive.name}")
        version = root.run(f"{folder}/loosepin --version")
        version_printed(version, root)
        example, *others = readme.commands()
        study = root.run(f"{folder}/loosepin {example}")
        count = readme.compare(study.text, root.system)
        require_pages(root, 1)
        steps = [
            Step(root.system, "archive: unpacked, --version", unpacked.seconds + version.seconds),
            Step(root.system, f"archive: the README's example, {count} lines as printed there", study.seconds),
        ]
        # A status of 1 says that a requirement is not met, which is an answer.
        others_run = [root.run(f"{folder}/loosepin {command} || [ $? = 1 ]") for command in others]
        require_pages(root, 1 + sum(command.split()[0] in WITH_PAGE for command in others))
        seconds = sum(answer.seconds for answer in others_run)
        return [*steps, Step(root.system, f"archive: the README's {len(others)} commands for an own mechanism", seconds)]


def wheel(suite: str) -> list[Step]:
    """The wheel is installed with NumPy; the Python lines of the README run, without a network."""
    built = released("loosepin-*.whl")
    with clean_root(suite, ("python3-venv", "ca-certificates")) as root:
        root.copy_in(built, f"/root/{built.name}")
        root.copy_in(REPOSITORY / CASES, f"/root/{CASES}")
        root.path("/root/readme.py").write_text(readme.python_lines(), encoding="utf-8")
        made = root.run("python3 -m venv venv")
        numpy = root.run("venv/bin/pip install --quiet --only-binary :all: numpy", network=True)
        installed = root.run(f"venv/bin/pip install --quiet --no-index {built.name}")
        version = root.run("venv/bin/python --version").text.strip()
        imported = root.run("venv/bin/python -c 'import loosepin'")
        lines = root.run("venv/bin/python readme.py")
        count = readme.compare(lines.text, root.system)
        require_pages(root, 1)
        return [
            Step(root.system, f"wheel: environment of {version} and NumPy", made.seconds + numpy.seconds),
            Step(root.system, "wheel: installed", installed.seconds),
            Step(root.system, "wheel: import loosepin, the first time", imported.seconds),
            Step(root.system, f"wheel: the README's Python lines, {count} lines as printed there", lines.seconds),
        ]


def package(suite: str) -> list[Step]:
    """The Debian package is installed by apt-get and removed, without a network; nothing is left."""
    built = released("loosepin_*.deb")
    wanted = [
        *(f"usr/share/man/man1/{page.name}.gz" for page in FILES.glob("man/*.1")),
        "usr/share/bash-completion/completions/loosepin",
        "usr/share/zsh/vendor-completions/_loosepin",
        "usr/share/fish/vendor_completions.d/loosepin.fish",
        "usr/share/doc/loosepin/copyright",
    ]
    with clean_root(suite) as root:
        before = root.files()
        root.copy_in(built, f"/root/{built.name}")
        installed = root.run(f"apt-get install --yes ./{built.name}")
        version_printed(root.run("loosepin --version"), root)
        for path in wanted:
            require(root.path(path).is_file(), f"{root.system}: {built.name} installs no {path}")
        root.run("bash -c '. /usr/share/bash-completion/completions/loosepin; complete -p loosepin'")
        root.run("zcat /usr/share/man/man1/loosepin.1.gz | grep --quiet '^.TH loosepin 1'")
        study = root.run(f"loosepin {readme.commands()[1]}; loosepin check my_mechanism/model.toml")
        removed = root.run("apt-get purge --yes loosepin")
        left = sorted(root.files() - before)
        require(not left, f"{root.system}: left behind by the package: {' '.join(left)}")
        return [
            Step(root.system, f"package: installed by apt-get, {len(wanted)} pages and completions there", installed.seconds),
            Step(root.system, "package: loosepin new, loosepin check", study.seconds),
            Step(root.system, "package: removed, nothing left", removed.seconds),
        ]


# Debian 11 has Python 3.9, and the wheel needs 3.10.
CHECKS: tuple[tuple[str, tuple[Callable[[str], list[Step]], ...]], ...] = (
    ("bullseye", (program, package)),
    ("bookworm", (program, wheel, package)),
    ("trixie", (program, wheel, package)),
)

