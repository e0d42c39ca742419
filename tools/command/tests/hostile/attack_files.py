"""Attacks by input files that are cut short at every length, or have some bytes changed."""
MESHES = ["above.obj", "ascii1.ply", "little1.ply", "big1.ply", "solid1.stl", "list1.off"]
QUERIES = ["asked/vertex-face/1.csv"]  # only tamis-lab reads such files
MUTATIONS = 400


def verbs_there(world, verbs):
    return [words for words in verbs if words[0] in [verb.name for verb in world.verbs]]


def cases(world):
    for name in MESHES + (QUERIES if verbs_there(world, [["queries"]]) else []):
        size = (world.template / name).stat().st_size
        yield from ((name, cut, None) for cut in range(size))
        yield from ((name, None, mutation) for mutation in range(MUTATIONS))


def mutated(data, random):
    """Return a copy with some bytes changed, removed, doubled or copied from elsewhere."""
    data = bytearray(data)
    for _ in range(random.choice([1, 1, 2, 5, 20])):
        at, other = random.randrange(len(data) + 1), random.randrange(len(data) + 1)
        size = random.choice([1, 1, 2, 8])
        piece = random.choice([bytes([random.randrange(256)]), data[other:other + size], b"", b"-1", b"1e308", b"999999999999",
                               b"nan", b"\xff\xff\xff\xff", b"\x00" * size, b"\n", b" "])
        data[at:at + random.choice([0, 1, size])] = piece
    return bytes(data)


def attack(folder, case, random):
    name, cut, _ = case
    path = folder.path / name
    data = path.read_bytes()
    path.write_bytes(mutated(data, random) if cut is None else data[:cut])
    if name.endswith(".csv"):
        verbs = [["queries", "asked"]]
    else:
        other = name.replace("1.", "2.").replace("above", "below")
        verbs = [["info", name], ["contacts", name, other, "--out", "c.csv"], ["is-free", other, name], ["earliest", name, name],
                 ["sequence", other, name]]
    outcome = folder.run_and_check(random.choice(verbs_there(folder.world, verbs)) + random.choice([[], ["--json"]]))
    # An ASCII file without its last digit or line end cannot be told from a complete one.
    if cut is not None and name.endswith(".ply") and (name != "ascii1.ply" or cut < len(data) - 2):
        outcome.require(outcome.code == 2, f"{name} cut after {cut} bytes was taken")
    outcome.require(outcome.code != 2 or not (folder.path / "c.csv").exists(), "a file was written in spite of the error")
