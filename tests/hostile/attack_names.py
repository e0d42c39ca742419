"""Names of files and folders with all that a name may hold."""
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
    # A label that is a name is the caller's choice; what a path holds is not.
    outcome.require(outcome.code == expected, f"exit code {expected} under another name")
    if json_flag:
        json.loads(outcome.out, object_pairs_hook=lambda pairs: require_unique(outcome, pairs))


def require_unique(outcome, pairs):
    keys = [key for key, _ in pairs]
    outcome.require(len(keys) == len(set(keys)), "a key stands twice")
    return dict(pairs)


def rename(here, word, name):
    """Moves an input into a folder of that name; outputs go there too. Other words stay."""
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
    """A dash at the beginning is an option's."""
    return f"./{name}" if name.startswith("-") else name
