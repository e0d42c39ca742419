"""Attacks by values that no option takes, and by words where none belongs."""
EMPTY = ["", None]  # `--option ""`, and `--option=`
NO_NUMBERS = ["nan", "-nan", "inf", "-inf", "-1", "1e999", "-1e-999x", "0x10", "1x", "x", " 1", "1 ", "1;1", "--", "[1]", "%s%n",
              "1\n", "9" * 400, "1_000", "1'000", "\udcff", "\x1b[2J", "--json"]
NAMES = ["nan", "[x]", "%s%n%n", "x" * 5000, "\udcff\udcfe", "\x1b]0;x\x07", "a\nb", "../..", "--json", "'", '"', "{}", "*"]


def cases(world):
    for verb in world.verbs:
        for option in verb.options:
            values = EMPTY + (NO_NUMBERS if option.is_number else [] if option.is_flag else NAMES)
            yield from ((verb, option, value) for value in values)
        yield from ((verb, None, word) for word in ["", "--no-such-option", "-x", "--=", "extra", "\udcff", "--help"])


def attack(folder, case, random):
    verb, option, value = case
    words = folder.world.baseline(verb)
    if option is None:
        added = [value]
    else:
        added = [f"{option.name}="] if value is None else [option.name, value]
    before = folder.contents()
    outcome = folder.run_and_check(words + added)
    if option and (value in EMPTY or option.is_number):
        outcome.require(outcome.code == 2, "a value that is none was taken")
        outcome.require(option.name in outcome.err.decode() or "argument" in outcome.err.decode(), "the option is not named")
        outcome.require(folder.contents() == before, "refused, and yet something was written")
    if option is None and value not in ("--help", "extra"):
        outcome.require(outcome.code == 2, "a word that means nothing was taken")
    folder.require_nothing_unfinished(outcome)
