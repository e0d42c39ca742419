"""Attacks by outputs that exist already, are links, are inputs, or cannot be written."""
import os
import stat

import inputs

PLACES = ["new", "private", "public", "executable", "link", "dangling", "folder", "absent folder", "/dev/null", "/dev/full",
          "long name", "too long", "looping link", "through a file"]
SPELLINGS = ["as it is", "dotted", "link", "link to link", "hard link", "absolute"]


def output_of(verb):
    return next((option for option in verb.options if option.is_output_file), None)


def cases(world):
    for verb in world.verbs:
        if output_of(verb):
            is_free = verb.name not in inputs.SUFFIXES
            yield from ((verb, place, None) for place in PLACES if is_free or not place.startswith("/dev"))
            for position in range(len(inputs_in(world.baseline(verb), world.template))):
                yield from ((verb, spelling, position) for spelling in SPELLINGS)


def inputs_in(words, folder):
    return [word for word in words if (folder / word).is_file()]


def attack(folder, case, random):
    verb, kind, position = case
    words = folder.world.baseline(verb)
    if position is None:
        return attack_place(folder, words, output_of(verb).name, kind, inputs.SUFFIXES.get(verb.name, ""))
    return attack_input(folder, words, output_of(verb).name, kind, inputs_in(words, folder.path)[position])


def attack_input(folder, words, option, spelling, name):
    here = folder.path
    if spelling == "hard link":
        os.link(here / name, here / "hard")
    (here / "link").symlink_to(name)
    (here / "again").symlink_to("link")
    out = {"as it is": name, "dotted": f"./bin/../{name}", "link": "link", "link to link": "again", "hard link": "hard",
           "absolute": str(here / name)}[spelling]
    before = folder.contents()
    outcome = folder.run_and_check([*words, option, out])
    outcome.require(outcome.code == 2, f"{option} {out} is the input {name}")
    outcome.require(folder.contents() == before, "an input was changed")


def prepare(out, place):
    """Put at `out` what the name of the place says."""
    modes = {"private": 0o600, "public": 0o666, "executable": 0o755}
    if place in modes:
        out.write_text("old")
        out.chmod(modes[place])
    if place == "link":
        out.with_name("behind").write_text("old")
    if place in ("link", "dangling"):
        out.symlink_to("behind")
    if place == "folder":
        out.mkdir()
    if place == "looping link":
        out.symlink_to(out.name)


def name_of(place, suffix):
    long = {"long name": 255, "too long": 256}
    if place in long:
        return "x" * (long[place] - len(suffix)) + suffix
    folders = {"absent folder": "absent/", "through a file": "above.obj/"}
    return place if place.startswith("/dev") else folders.get(place, "") + "out" + suffix


def attack_place(folder, words, option, place, suffix):
    name = name_of(place, suffix)
    can_be = place not in ("folder", "absent folder", "/dev/full", "too long", "looping link", "through a file")
    if not place.startswith("/dev"):
        prepare(folder.path / name, place)
    out, files = folder.path / name, folder.files()
    mode = stat.S_IMODE(out.stat().st_mode) if place in ("private", "public", "executable") else None
    outcome = folder.run_and_check([*words, option, name])
    outcome.require((outcome.code == 2) != can_be, f"{option} {name}: {place}")
    folder.require_nothing_unfinished(outcome)
    if not can_be:
        outcome.require(folder.files() == files, "refused, and yet there is a new file")
    if mode is not None:
        outcome.require(stat.S_IMODE(out.stat().st_mode) == mode, "the permissions are not kept")
    if place in ("link", "dangling"):
        outcome.require(out.is_symlink() and (folder.path / "behind").stat().st_size > 3, "the link was not followed")
