#!/usr/bin/env python3
"""check_conda.py [RECIPE]: renders the recipe for conda packages by rattler-build, for Linux and macOS. Exits with 77 without PyPI."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STDLIB = {"linux-64": "sysroot", "linux-aarch64": "sysroot", "osx-arm64": "macosx_deployment_target"}


def run_with_rattler_build() -> int:
    pinned = subprocess.run([ROOT / "scripts" / "pinned.sh", "python", "conda"], stdout=subprocess.PIPE, text=True, check=False)
    if pinned.returncode:
        print(pinned.stdout, end="")
        return pinned.returncode
    return subprocess.run([pinned.stdout.strip(), __file__, *sys.argv[1:]], check=False).returncode


def render(path: str, platform: str) -> None:
    config = rattler_build.RenderConfig(platform=rattler_build.PlatformConfig(
        target_platform=platform, build_platform=platform, host_platform=platform))
    variants = rattler_build.VariantConfig({"c_stdlib": [STDLIB[platform]]})
    (variant,) = rattler_build.Stage0Recipe.from_file(path).render(variants, config)
    recipe = variant.recipe.to_dict()
    needs = recipe["requirements"]
    print(f"{platform}: {recipe['package']['name']} {recipe['package']['version']}: {', '.join(needs['build'] + needs['host'])}")


if __name__ == "__main__":
    try:
        import rattler_build
    except ImportError:
        sys.exit(run_with_rattler_build())
    for platform in STDLIB:
        render(sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "packaging" / "conda" / "recipe.yaml"), platform)
