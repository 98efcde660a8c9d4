// SPDX-License-Identifier: LGPL-2.1-or-later
#include "manual.h"

#include <vector>

#include "options.h"

namespace swept::cli {
namespace {

using Options = std::vector<const CLI::Option*>;

std::vector<const CLI::App*> commandsOf(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

// Returns the options for manual page and completions. Leaves out earlier names of options, which
// have no group (keepEarlierName()).
Options optionsOf(const CLI::App& app, bool positional) {
  return app.get_options([positional](const CLI::Option* o) {
    return o->get_positional() == positional && !o->get_group().empty();
  });
}

bool takesValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

// Returns the allowed words of an option; none if any value is allowed.
std::vector<std::string> wordsOf(const CLI::Option& option) {
  const std::string kind = takesValue(option) ? option.get_type_name() : std::string();
  return kind.find('|') == std::string::npos ? std::vector<std::string>{}
                                             : CLI::detail::split(kind, '|');
}

std::vector<std::string> namesOf(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// Escapes text for man: backslashes, and hyphens, so that options can be copied.
std::string roff(const std::string& text) {
  return replaced(replaced(text, "\\", "\\e"), "-", "\\-");
}

std::string optionEntry(const CLI::Option& option) {
  std::string head;
  for (const std::string& name : namesOf(option))
    head += (head.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  if (option.get_positional())
    head = "\\fI" + roff(option.get_name(true)) + "\\fR";
  else if (takesValue(option))
    head += " \\fI" + roff(option.get_type_name()) + "\\fR";
  return ".TP\n" + head + "\n" + roff(option.get_description()) + "\n";
}

std::string shellQuoted(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}

std::string joined(const std::vector<std::string>& words) { return CLI::detail::join(words, " "); }

std::string bashCompletions(const CLI::App& program) {
  std::vector<std::string> commands;
  std::string cases, values;
  for (const CLI::App* app : commandsOf(program)) {
    commands.push_back(app->get_name());
    std::vector<std::string> names;
    for (const CLI::Option* option : optionsOf(*app, false)) {
      const std::vector<std::string> own = namesOf(*option);
      names.insert(names.end(), own.begin(), own.end());
      if (wordsOf(*option).empty()) continue;
      values += "    " + app->get_name() + ":" + own.back() +
                ") words=" + shellQuoted(joined(wordsOf(*option))) + " ;;\n";
    }
    cases += "    " + app->get_name() + ") words=" + shellQuoted(joined(names)) + " ;;\n";
  }
  return "# Completions of swept for bash.\n_swept() {\n  local word=${COMP_WORDS[COMP_CWORD]} "
         "words=\n"
         "  if [ \"$COMP_CWORD\" = 1 ]; then\n    words=" +
         shellQuoted(joined(commands) + " --help --version") +
         "\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n    return\n  fi\n"
         "  case ${COMP_WORDS[1]}:${COMP_WORDS[COMP_CWORD-1]} in\n" +
         values +
         "  esac\n  if [ -n \"$words\" ]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n    return\n  fi\n"
         "  if [[ $word = -* ]]; then\n    case ${COMP_WORDS[1]} in\n" +
         cases +
         "    esac\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n    return\n "
         " fi\n"
         "  mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n}\n"
         "complete -o filenames -F _swept swept\n";
}

std::string zshCompletions(const CLI::App& program) {
  std::string commands, cases;
  const auto plain = [](const std::string& text) {
    return replaced(replaced(replaced(text, "[", "("), "]", ")"), ":", " -");
  };
  for (const CLI::App* app : commandsOf(program)) {
    commands += "    " + shellQuoted(app->get_name() + ":" + plain(app->get_description())) + "\n";
    cases += "    " + app->get_name() + ")\n      _arguments";
    for (const CLI::Option* option : optionsOf(*app, false)) {
      for (const std::string& name : namesOf(*option)) {
        std::string entry = name + "[" + plain(option->get_description()) + "]";
        const std::vector<std::string> words = wordsOf(*option);
        if (!words.empty())
          entry += ":word:(" + joined(words) + ")";
        else if (takesValue(*option))
          entry += ":" + option->get_type_name() + ":_files";
        cases += " \\\n        " + shellQuoted(entry);
      }
    }
    cases += " \\\n        '*:file:_files' ;;\n";
  }
  return "#compdef swept\n# Completions of swept for zsh.\n_swept() {\n  local -a commands\n  "
         "commands=(\n" +
         commands +
         "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
         "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n" +
         cases + "  esac\n}\n_swept \"$@\"\n";
}

std::string fishCompletions(const CLI::App& program) {
  std::string text = "# Completions of swept for fish.\n";
  const auto fishQuoted = [](const std::string& t) {
    return "'" + replaced(replaced(t, "\\", "\\\\"), "'", "\\'") + "'";
  };
  for (const CLI::App* app : commandsOf(program)) {
    text += "complete -c swept -n __fish_use_subcommand -f -a " + app->get_name() + " -d " +
            fishQuoted(app->get_description()) + "\n";
    for (const CLI::Option* option : optionsOf(*app, false)) {
      text += "complete -c swept -n '__fish_seen_subcommand_from " + app->get_name() + "'";
      for (const std::string& name : option->get_snames()) text += " -s " + name;
      for (const std::string& name : option->get_lnames()) text += " -l " + name;
      if (!wordsOf(*option).empty())
        text += " -x -a " + fishQuoted(joined(wordsOf(*option)));
      else if (takesValue(*option))
        text += " -r";
      text += " -d " + fishQuoted(option->get_description()) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string manualPage(const CLI::App& program) {
  std::string text =
      ".TH SWEPT 1\n.SH NAME\nswept \\- " + roff(program.get_description()) +
      "\n.SH SYNOPSIS\n.B swept\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] \\fIFILE\\fR...\n";
  for (const CLI::App* app : commandsOf(program)) {
    text += ".SH SWEPT " + roff(CLI::detail::to_lower(app->get_name())) + "\n" +
            roff(app->get_description()) + "\n";
    for (const CLI::Option* option : optionsOf(*app, true)) text += optionEntry(*option);
    for (const CLI::Option* option : optionsOf(*app, false)) text += optionEntry(*option);
    text += ".PP\n.nf\n" + roff(app->get_footer()) + "\n.fi\n";
  }
  return text + ".SH EXIT STATUS\n.nf\n" + roff(program.get_footer()) + "\n.fi\n";
}

std::string completions(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bashCompletions(program);
  if (shell == "zsh") return zshCompletions(program);
  if (shell == "fish") return fishCompletions(program);
  badOption("there are no completions for '" + shell + "'; allowed: bash, zsh, fish");
}

}  // namespace swept::cli
