#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""help_pages.py PROGRAM MAN BASH: the program's --help as a manual page and a bash completion.

Nothing is written here that --help does not say, but for the frame of the page and the exit status.
"""
import dataclasses
import json
import re
import subprocess
import sys

COLUMN = 30  # where CLI11 starts the second column


@dataclasses.dataclass
class Command:
    words: list       # of the command line: halfspace, render
    usage: str = ""
    text: str = ""
    footer: list = dataclasses.field(default_factory=list)
    sections: dict = dataclasses.field(default_factory=dict)  # heading: [(name, description)]
    listed: dict = dataclasses.field(default_factory=dict)  # option or argument: names of a list

    def children(self):
        return [name for name, _ in self.sections.get("Subcommands", [])]


def read_entry(line, entries):
    """One line of a section: a name and its description, or what belongs to the line before."""
    if len(line) >= COLUMN and not line[:COLUMN].strip():
        name, text = entries.pop()
        entries.append((name, f"{text} {line.strip()}".strip()))
    elif len(line) > COLUMN and line[COLUMN - 1] == " ":
        entries.append((line[:COLUMN].strip(), line[COLUMN:].strip()))
    else:
        entries.append((line.strip(), ""))


def output(program, *words):
    """What a command prints; nothing where the build lacks what it lists."""
    return subprocess.run([program, *words], capture_output=True, text=True, check=False).stdout


def add_lists(program, command):
    """Names that --help leaves to another command: its own --list, or `halfspace methods`."""
    for section in ("Positionals", "Options"):
        for name, text in command.sections.get(section, []):
            if "halfspace methods" in text:
                names = [method["name"] for method in json.loads(output(program, "methods",
                                                                        "--json") or "[]")]
            elif "see --list" in text:
                lines = output(program, *command.words[1:], "--list").splitlines()
                names = [line.split()[0] for line in lines if not line.startswith(" ")]
            else:
                continue
            command.listed[name.split(" ")[0]] = names


def read_help(program, words):
    """The command's --help, and that of the commands below it."""
    shown = subprocess.run([program, *words[1:], "--help"], capture_output=True, text=True,
                           check=True).stdout.splitlines()
    command = Command(words)
    entries = None
    for line in shown:
        if line.startswith("Usage: "):
            command.usage = line.removeprefix("Usage: ")
        elif not command.usage:
            command.text = f"{command.text} {line}".strip()
        elif re.fullmatch(r"[A-Z][A-Za-z ]*:", line):
            entries = command.sections.setdefault(line[:-1], [])
        elif line.startswith("  ") and entries is not None:
            read_entry(line, entries)
        elif line.strip():
            command.footer.append(line)
    add_lists(program, command)
    if not command.usage or not command.text:
        raise SystemExit(f"help_pages.py: {' '.join(words)} --help has no usage or no description")
    below = [read_help(program, [*words, child]) for child in command.children()]
    return [command, *[one for list_ in below for one in list_]]


# --- The manual page ------------------------------------------------------------------------------


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def roff_entries(entries):
    out = []
    for name, text in entries:
        # A line may end after each of an option's choices.
        out += [".TP", f".B {roff(name)}".replace("|", "|\\:"), roff(text) or "\\&"]
    return out


def manual(commands, version):
    top = commands[0]
    name, text = top.words[0], top.text.split(": ", 1)[-1]
    out = ['.\\" Made from --help by help_pages.py: do not edit.',
           f'.TH {name.upper()} 1 "" "{roff(version)}" "User Commands"',
           ".SH NAME", f"{name} \\- {roff(text)}", ".SH SYNOPSIS"]
    for command in commands[1:]:
        if not command.children():
            out += [f".B {' '.join(command.words)}",
                    roff(command.usage.removeprefix(" ".join(command.words)).strip()), ".br"]
    out += [".SH DESCRIPTION", roff(text[0].upper() + text[1:]) + ".",
            "Results go to files or standard output, messages to standard error.",
            ".SH OPTIONS", *roff_entries(top.sections.get("Options", [])), ".SH COMMANDS"]
    for command in commands[1:]:
        out += [f".SS {' '.join(command.words[1:])}", roff(command.text) + "."]
        for heading, entries in command.sections.items():
            if heading != "Subcommands":
                out += roff_entries(e for e in entries if not e[0].startswith("-h,"))
        for line in command.footer:
            out += [".PP", roff(line)]
    out += [".SH EXIT STATUS", ".TP", ".B 0", "Done.", ".TP", ".B 1", "A comparison failed.",
            ".TP", ".B 2", "Bad input, or interrupted: one line on standard error,",
            ".IR \"halfspace: error[HSnnn]: PLACE: WHAT AND WHY\" ,",
            "and no output file is left behind."]
    return "\n".join(out) + "\n"


# --- The completion -------------------------------------------------------------------------------


def choices(name, text):
    """The words that an option takes, when --help lists them."""
    # A default follows the kind: "a|b=a" by CLI11 2.1, "a|b [a]" by 2.4.
    kind = re.split("[ =]", name)[1] if " " in name else ""
    if re.fullmatch(r"[a-z0-9_]+(\|[a-z0-9_]+)+", kind):
        return kind.split("|")
    if re.fullmatch(r"[a-z_]+(, [a-z_]+)* or [a-z_]+", text):
        return re.split(r", | or ", text)
    presets = re.match(r"Preset \(([a-z0-9, ]+)\)", text)
    return presets.group(1).split(", ") if presets else []


def offer(pattern, words):
    return f"      '{' '.join(pattern)}') words='{' '.join(words)}' ;;"


def completion(commands):
    lines = ["# bash completion of halfspace. Made from --help by help_pages.py: do not edit.",
             "_halfspace() {",
             "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}",
             "  local path=${COMP_WORDS[0]##*/} word words=", "  COMPREPLY=()",
             "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do",
             "    case \"$path $word\" in"]
    for command in commands[1:]:
        joined = " ".join(command.words)
        lines.append(f"      '{joined}') path='{joined}' ;;")
    lines += ["    esac", "  done", "  case \"$path $previous\" in"]
    for command in commands:
        for name, text in command.sections.get("Options", []):
            option = name.split(" ")[0].split(",")[-1]
            if values := command.listed.get(option) or choices(name, text):
                lines.append(offer([*command.words, option], values))
    lines.append(offer([*commands[0].words, "help"], commands[0].children()))
    lines += ["  esac", "  if [[ -z $words && $current == -* ]]; then", "    case $path in"]
    for command in commands:
        names = [part for name, _ in command.sections.get("Options", [])
                 for part in name.split(" ")[0].split(",")]
        lines.append(offer(command.words, names))
    lines += ["    esac", "  elif [[ -z $words ]]; then", "    case $path in"]
    for command in commands:
        if command.children():
            lines.append(offer(command.words, [*command.children(), "help"]))
        elif "NAME" in command.listed:
            lines.append(offer(command.words, command.listed["NAME"]))
    lines += ["    esac", "  fi",
              "  [[ -n $words ]] &&",
              "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")",
              "  return 0", "}",
              "# Where there is nothing to offer, file names.",
              "complete -o default -F _halfspace halfspace"]
    return "\n".join(lines) + "\n"


def main():
    program, man, bash = sys.argv[1:]
    version = subprocess.run([program, "--version"], capture_output=True, text=True,
                             check=True).stdout.strip()
    commands = read_help(program, ["halfspace"])
    for path, text in ((man, manual(commands, version)), (bash, completion(commands))):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
