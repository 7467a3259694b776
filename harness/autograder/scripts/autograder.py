#!/usr/bin/env python3
"""Grades the checkout in the working directory with raygrade. The runner of Classroom 50 starts this for each submission. It exits
with 0 and leaves result.json, or with another status and leaves none: then nobody gets 0 points for a failure of the machine."""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
RESULT = pathlib.Path("result.json")


def main():
    RESULT.unlink(missing_ok=True)  # a student may have handed one in
    assignment = next((HERE / "assignment").glob("*.toml"))
    options = (HERE / "options").read_text(encoding="utf-8").splitlines()
    try:
        return subprocess.run(["raygrade", "check", ".", "--assignment", assignment, "--classroom50", RESULT, *options],
                              timeout=9 * 60, check=False).returncode
    except FileNotFoundError:
        print("::error::raygrade is not in this container. Build its image as described in the manual of raygrade, lms.md.")
    except subprocess.TimeoutExpired:
        print("::error::raygrade took longer than 9 minutes and was stopped.")
    return 1


sys.exit(main())
