"""Attacks by combined options at the ends of their ranges, on coordinates at the ends of theirs: any answer is right,
but the command must end as it should."""
import re

NUMBERS = ["0", "-0", "5e-324", "1e-300", "0.5", "0.999999999", "1", "3", "1e10", "1e300", "1.7976931348623157e308"]
# Small counts, as a million runs or triangles take long; but a thousand threads do not.
COUNTS = ["0", "1", "2", "3", "7"]
THREADS = COUNTS + ["64", "1024"]
NAMES = ["tamis", "paper", "brute", "paper-sat", "paper-pfs", "best", "baseline", "avx2", "avx512",
         "sphere", "aabb", "obb", "16-dop", "26-dop", "contacts", "earliest", "free", "none", "report", "ignore", "fail"]
COORDINATES = ["0", "-0", "1", "-1", "0.1", "1e-324", "5e-324", "2.2250738585072014e-308", "1e-160", "1e160", "1e308",
               "-1.7976931348623157e308", "4503599627370497", "0.30000000000000004"]
COUNT = 300


def cases(world):
    """Yield each value of each option once, then cases with random options together."""
    for verb in world.verbs:
        for option in plain_options(world, verb):
            yield from ((verb, [option.name, value]) for value in values_of(option))
        yield from ((verb, None) for _ in range(COUNT))


def plain_options(world, verb):
    words = world.baseline(verb)
    return [o for o in verb.options if not o.is_output_file and not o.is_output_folder and "=" not in o.takes
            and not o.is_flag and o.name not in words]


def values_of(option):
    if not option.is_number:
        return NAMES
    if option.name == "--threads":
        return THREADS
    return COUNTS if re.match(r"N\b|INT|UINT", option.takes) else NUMBERS


def extreme_mesh(random, points):
    lines = [f"v {' '.join(random.choice(COORDINATES) for _ in range(3))}" for _ in range(points)]
    return "\n".join(lines) + "\n"


def attack(folder, case, random):
    verb, added = case
    words = folder.world.baseline(verb) + (added or [])
    if added is None:
        plain = plain_options(folder.world, verb)
        for option in random.sample(plain, min(len(plain), random.choice([1, 2, 3, 5]))):
            words += [option.name, random.choice(values_of(option))]
        words += random.choice([[], ["--json"] if verb.has("--json") else []])
        write_extreme_meshes(folder, random)
    outcome = folder.run_and_check(words)
    folder.require_nothing_unfinished(outcome)


def write_extreme_meshes(folder, random):
    if random.random() < 0.7:
        points = random.choice([3, 4, 6, 9])
        faces = "".join(f"f {' '.join(str(random.randrange(points) + 1) for _ in range(3))}\n" for _ in range(points // 2))
        for name in ("above.obj", "high.obj", "below.obj", "fall/1.obj", "fall/2.obj"):
            (folder.path / name).write_text(extreme_mesh(random, points) + faces + "p 1\n")
