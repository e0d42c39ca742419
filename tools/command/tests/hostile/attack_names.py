"""Attacks by names of files and folders with every kind of character."""
import json
import shutil

NAMES = ["\udcff\udcfe", "a\udcc3", "\x1b[31m", "\x1b]0;title\x07", "a\nb", "a\tb", " ", "a b", "'", '"', "a,b", "{}", "%s%n", "$(x)",
         "`x`", "\\", "*", "[a,b]", "[x]", "?", "-x", "--json", "=", "a=b", "\u202ex", "\u0085", "\xe4\u03b1\U0001f9f5", "x" * 240, "|", "#", "~"]


def cases(world):
    for verb in world.verbs:
        for name in NAMES:
            yield verb, name
            if verb.has("--json"):
                yield verb, name, "--json"


def attack(folder, case, random):
    verb, name, *json_flag = case
    words = folder.world.baseline(verb)
    expected = folder.run(words).code
    shutil.rmtree(folder.path / "laboratory", ignore_errors=True)
    shutil.rmtree(folder.path / "frames", ignore_errors=True)
    renamed = words[:1] + [rename(folder.path, word, name) for word in words[1:]]
    outcome = folder.run_and_check(renamed + json_flag)
    # The name stands in paths only, so it must not change the answer.
    outcome.require(outcome.code == expected, f"exit code {expected} under another name")
    if json_flag:
        json.loads(outcome.out, object_pairs_hook=lambda pairs: require_unique(outcome, pairs))


def require_unique(outcome, pairs):
    keys = [key for key, _ in pairs]
    outcome.require(len(keys) == len(set(keys)), "a key stands twice")
    return dict(pairs)


def rename(here, word, name):
    """Move an input into a folder of that name, and return its new path; outputs get that name. Other words stay."""
    if word in ("frames", "laboratory"):
        return safe(name)
    label, sign, path = word.partition("=") if "=" in word else ("", "", word)
    if not (here / path).exists():
        return word
    folder = here / name
    folder.mkdir(exist_ok=True)
    if not (folder / path).exists():
        (here / path).rename(folder / path)
    return f"{label}{sign}{safe(name)}/{path}"


def safe(name):
    """Return a name that the command does not take for an option."""
    return f"./{name}" if name.startswith("-") else name
