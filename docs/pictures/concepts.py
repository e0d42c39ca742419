#!/usr/bin/env python3
"""concepts.py [FOLDER]: writes the six figures of docs/concepts.md as SVG. Needs only Python.

Contact times and gaps in the figures are computed from the drawn points.
"""
import pathlib
import sys

WIDTH, HEIGHT = 720, 260
INK, SOFT, FREE, HIT, MOVING, STILL = "#1f2733", "#8a94a3", "#2a9d6f", "#e8701a", "#2f6fb5", "#6b7280"


def text(x, y, words, color=INK, size=14, anchor="start", weight="normal"):
    return (f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}" font-size="{size}" text-anchor="{anchor}" '
            f'font-weight="{weight}">{words}</text>')


def line(p, q, color=INK, width=2.0, dash="", arrow=False):
    end = f' marker-end="url(#{color[1:]})"' if arrow else ""
    return (f'<line x1="{p[0]:.1f}" y1="{p[1]:.1f}" x2="{q[0]:.1f}" y2="{q[1]:.1f}" stroke="{color}" '
            f'stroke-width="{width}" stroke-dasharray="{dash}"{end}/>')


def path(points, color=INK, width=2.0, fill="none", opacity=1.0, dash="", closed=False):
    corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return (f'<{"polygon" if closed else "polyline"} points="{corners}" fill="{fill}" fill-opacity="{opacity}" '
            f'stroke="{color}" stroke-width="{width}" stroke-dasharray="{dash}" stroke-linejoin="round"/>')


def dot(p, color=INK, radius=4.5, fill=None):
    return (f'<circle cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="{radius}" fill="{fill or color}" stroke="{color}" '
            f'stroke-width="1.5"/>')


def box(x, y, width, height, color, opacity=1.0):
    return f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{color}" opacity="{opacity}"/>'


def figure(title, *parts):
    arrows = "".join(
        f'<marker id="{c[1:]}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" orient="auto">'
        f'<path d="M0 0L10 5L0 10z" fill="{c}"/></marker>' for c in (INK, SOFT, FREE, HIT, MOVING, STILL))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
            f'font-family="Helvetica, Arial, sans-serif" role="img"><title>{title}</title><defs>{arrows}</defs>'
            f'<rect width="{WIDTH}" height="{HEIGHT}" rx="10" fill="#ffffff"/>' + "\n".join(parts) + "</svg>\n")


def between(p, q, t):
    return (p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]))


def side(p, a, b):
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def touch_time(p, q, a, b):
    """Return when a point on its way from p to q meets the line through a and b, which stand still."""
    return side(p, a, b) / (side(p, a, b) - side(q, a, b))


def step():
    start = [(70, 60), (190, 42), (310, 66), (430, 48)]
    end = [(100, 120), (225, 205), (345, 222), (455, 130)]
    ground = [(40, 180), (480, 195)]
    time, p, q = min((touch_time(p, q, *ground), p, q) for p, q in zip(start[1:3], end[1:3]))
    return figure(
        "A step", path(ground, STILL, 3), path(start, MOVING, 2.5), path(end, MOVING, 2.5, dash="6 4"),
        *(line(a, b, SOFT, 1.5, arrow=True) for a, b in zip(start, end)), *(dot(a, MOVING) for a in start),
        *(dot(b, MOVING, fill="#ffffff") for b in end), dot(between(p, q, time), HIT, 7),
        text(44, 34, "start: t = 0", MOVING, weight="bold"), text(372, 236, "end: t = 1", MOVING, weight="bold"),
        text(40, 236, "an obstacle that stays", STILL),
        text(510, 70, "Every vertex goes straight"), text(510, 90, "from its start to its end."),
        text(510, 132, f"First contact: t = {time:.2f}", HIT, weight="bold"),
        text(510, 162, "The end lies behind it:"), text(510, 182, "a test of poses alone may"), text(510, 202, "see it too late, or never."))


def bracket():
    left, right, hit = 60, 660, 300
    return figure(
        "A bracket", text(left, 40, "one step", weight="bold"), box(left, 56, hit - left, 26, FREE, 0.85),
        box(hit - 1.5, 56, 3, 26, HIT), box(hit + 1.5, 56, right - hit, 26, SOFT, 0.3), text(left, 104, "t = 0", SOFT),
        text(right, 104, "t = 1", SOFT, anchor="end"), text(180, 74, "free, proven", "#ffffff", anchor="middle"),
        text(480, 74, "after the first touch", INK, anchor="middle"),
        path([(hit - 1.5, 84), (130, 150), (590, 150), (hit + 1.5, 84)], SOFT, 1, "#f3e3d5", 0.8, closed=True),
        text(360, 138, "magnified 10,000,000,000,000 times", SOFT, 12, "middle"),
        box(130, 150, 140, 34, FREE, 0.85), box(270, 150, 180, 34, HIT), box(450, 150, 140, 34, SOFT, 0.3),
        text(200, 172, "free, proven", "#ffffff", anchor="middle"), text(360, 172, "touches in here", "#ffffff", anchor="middle"),
        line((270, 150), (270, 200), INK, 1.5), line((450, 150), (450, 200), INK, 1.5),
        text(270, 218, "toi_lower", anchor="middle", weight="bold"), text(450, 218, "toi_upper", anchor="middle", weight="bold"),
        text(360, 246, "usually 1e-13 of the step wide, at most 1e-11", SOFT, anchor="middle"))


def certificate():
    a0, a1 = [(70, 60), (120, 120)], [(180, 40), (225, 105)]
    b0, b1 = [(290, 150), (370, 120)], [(330, 60), (400, 90)]
    axis = 222
    spans = [(min(p[0] for p in a0 + a1), max(p[0] for p in a0 + a1)), (min(p[0] for p in b0 + b1), max(p[0] for p in b0 + b1))]
    return figure(
        "A certificate", path([a0[0], a1[0], a1[1], a0[1]], MOVING, 1, MOVING, 0.18, closed=True),
        path([b0[0], b1[0], b1[1], b0[1]], HIT, 1, HIT, 0.18, closed=True), path(a0, MOVING, 3.5), path(a1, MOVING, 3.5, dash="6 4"),
        path(b0, HIT, 3.5), path(b1, HIT, 3.5, dash="6 4"), line((50, axis), (440, axis), INK, 1.5, arrow=True),
        *(line((x, axis - 12), (x, 140 if x < 250 else 150), SOFT, 1, "3 4") for span in spans for x in span),
        box(spans[0][0], axis - 5, spans[0][1] - spans[0][0], 10, MOVING, 0.8), box(spans[1][0], axis - 5, spans[1][1] - spans[1][0], 10, HIT, 0.8),
        box(spans[0][1], axis - 3, 8, 6, SOFT), box(spans[1][0] - 8, axis - 3, 8, 6, SOFT),
        text((spans[0][1] + spans[1][0]) / 2, axis + 26, "gap", FREE, anchor="middle", weight="bold"),
        text(446, axis + 5, "an axis", SOFT),
        text(470, 60, "Two edges move."), text(470, 80, "Along this axis they stay apart:"),
        text(470, 112, "gap &gt; error bound (grey)", FREE, weight="bold"),
        text(470, 144, "A strict inequality, larger than"), text(470, 164, "all rounding: the pair is free."))


def separation():
    surface = [(40, 190), (250, 160), (460, 190)]
    d, r = 28, 18
    above = [(x, y - d - r) for x, y in surface]
    ball = (310, 0)
    stop = between(surface[1], surface[2], (ball[0] - 250) / 210)[1] - d - r
    p = (ball[0], stop - r)
    return figure(
        "Separation and radii", path(above + surface[::-1], "none", 0, HIT, 0.13, closed=True),
        path(surface, STILL, 3), path(above, HIT, 1.5, dash="5 4"), path([(x, y - r) for x, y in surface], STILL, 1, dash="2 4"),
        line((ball[0], 30), (ball[0], p[1] - r), SOFT, 1.5, arrow=True), dot(p, MOVING, r, "#dbe8f6"), dot(p, MOVING, 3.5),
        dot((ball[0], p[1] + r), HIT, 5),
        line((110, 180 - r), (110, 180), INK, 1.5), text(118, 176, "radius of the surface", size=12),
        line((140, 176 - r - d), (140, 176 - r), INK, 1.5), text(148, 148, "min_separation", size=12),
        text(p[0] + r + 8, p[1] + 4, "radius of the point", MOVING, 12),
        text(480, 60, "In contact:", HIT, weight="bold"), text(480, 84, "distance at most"), text(480, 106, "min_separation + both radii"),
        text(480, 142, "Contact begins at the dashed"), text(480, 162, "line. All lengths have the"), text(480, 182, "unit of the positions."))


def safe_step():
    left, bottom, top, right, keep = 90, 210, 40, 470, 0.25
    def gap(t):
        return 1 - 1.25 * t
    def at(t, g):
        return (left + t * (right - left), bottom - g * (bottom - top))
    safe, first = (1 - keep) / 1.25, 1 / 1.25
    return figure(
        "A safe step", line((left, bottom), (right + 20, bottom), INK, 1.5, arrow=True), line((left, bottom), (left, top - 12), INK, 1.5, arrow=True),
        box(left, bottom + 1, at(safe, 0)[0] - left, 8, FREE, 0.85), line(at(0, keep), at(1, keep), FREE, 1.5, "5 4"),
        line(at(0, gap(0)), at(first, 0), MOVING, 3), dot(at(safe, keep), FREE, 6), dot(at(first, 0), HIT, 6),
        line(at(safe, keep), at(safe, 0), FREE, 1.5, "3 4"), text(100, 38, "distance of a pair", MOVING),
        text(right + 14, bottom + 24, "time", SOFT, anchor="end"), text(96, at(0, keep)[1] - 6, "keep x distance at the start", FREE, 12),
        text(at(safe, 0)[0], bottom + 28, "safe_step", FREE, 13, "end", "bold"), text(at(first, 0)[0] - 10, bottom + 28, "earliest", HIT, 13, weight="bold"),
        text(510, 70, "safe_step(step, keep):", weight="bold"), text(510, 94, "until then every pair"), text(510, 114, "keeps that part of its"),
        text(510, 134, "distance, proven."), text(510, 170, "keep = 0 ends at the"), text(510, 190, "first contact."))


def truncation():
    parts = []
    for shift, title, own in ((0, "safe_step: one time for all", False), (360, "truncate: each vertex by itself", True)):
        parts += [text(30 + shift, 34, title, weight="bold"), path([(x + shift, y) for x, y in ((30, 230), (70, 92), (110, 230))], STILL, 3)]
        xs, top, end = (70, 140, 210, 280), 60, 225
        low = (92 - top) * 0.9 / (end - top)
        goes = [low] + [(low if not own else 0.9 * t) for t in (0.62, 1.1, 1.1)]
        points = [(x + shift, top + min(g, 1) * (end - top)) for x, g in zip(xs, goes)]
        parts += [line((x + shift, top), (x + shift, end), SOFT, 1.2, "3 4", arrow=True) for x in xs]
        parts += [path([(x + shift, top) for x in xs], MOVING, 1.5, dash="6 4"), path(points, MOVING, 3)]
        parts += [dot(p, HIT if i == 0 else MOVING, 5.5) for i, p in enumerate(points)]
        parts.append(text(310 + shift, end - 4, "wanted", SOFT, 12, "middle"))
    return figure("Truncation", *parts, line((360, 20), (360, 245), SOFT, 0.8))


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (step, bracket, certificate, separation, safe_step, truncation):
        (folder / f"concept-{draw.__name__.replace('_', '-')}.svg").write_text(draw())


if __name__ == "__main__":
    main()
