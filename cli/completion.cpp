// SPDX-License-Identifier: Apache-2.0
#include "cli/completion.h"

#include <algorithm>
#include <cstddef>
#include <map>

#include "cli/adapter_names.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/generator.h"
#include "spec/clauses/clauses.h"

namespace toolcomp::cli {
namespace {

// Collects the candidates that begin with a word.
class Candidates {
 public:
  explicit Candidates(std::string_view word) : word_(word) {}

  void add(std::string_view candidate, std::string_view what) {
    if (!candidate.starts_with(word_)) return;
    text_.append(candidate).append(1, '\t').append(what).append(1, '\n');
  }
  void add_all(std::string_view names) {  // "a|b|c"
    while (!names.empty()) {
      const std::size_t end = std::min(names.find('|'), names.size());
      add(names.substr(0, end), "");
      names.remove_prefix(std::min(names.size(), end + 1));
    }
  }
  void ask(std::string_view what) { text_.append(1, ':').append(what).append(1, '\n'); }
  std::string take() { return std::move(text_); }

 private:
  std::string_view word_;
  std::string text_;
};

// What an option's word stands for.
void add_values(Candidates& candidates, const std::string& value) {
  if (value.find('|') != std::string::npos) return candidates.add_all(value);
  if (value == "SECTION" || value == "SECTION,…")
    for (const std::string_view section : fuzz::sections()) candidates.add(section, "section");
  if (value == "CLAUSE")
    for (const spec::ClauseInfo& clause : spec::clauses())
      candidates.add(clause.id, clause.text.substr(0, clause.text.find(". ")));
  if (value == "TARGET")
    for (const fuzz::Target& target : fuzz::targets()) candidates.add(target.name, "target");
  if (value == "CONTROLLER") candidates.add("spec", "the formal specification");
  if (value == "CONTROLLER" || value == "ADAPTER")
    for (const std::string& name : adapter_names({})) candidates.add(name, "adapter");
  if (value == "FILE" || value == "PROGRAM" || value == "SETUP") candidates.ask("files");
  if (value == "FOLDER") candidates.ask("folders");
}

// An argument whose meaning depends on the one before it, by verb and that one: what it takes there, or nothing.
std::string value_behind(const std::string& verb, const std::string& first, const std::string& value) {
  static const std::map<std::string, std::string> kTaken{{"spec show", "CLAUSE"},
                                                         {"config check", "FILE"},
                                                         {"config schema", "setup|case|event|hello|answer"},
                                                         {"corpus diff", "FOLDER"},
                                                         {"corpus merge", "FOLDER"}};
  if (verb == "kit") return first == "judge" ? value : "";
  if (verb != "spec" && verb != "config" && verb != "corpus") return value;
  const auto found = kTaken.find(verb + ' ' + first);
  return found == kTaken.end() ? "" : found->second;
}

// The words between the verb and the one to be completed.
struct Given {
  std::vector<std::string> arguments;
  std::vector<std::string> options;
  const OptionText* waits = nullptr;  // the option whose value comes next
  bool ended = false;                 // by --
};

const OptionText* find(const std::vector<OptionText>& options, const std::string& name) {
  const auto found = std::ranges::find_if(
      options, [&](const OptionText& o) { return std::ranges::find(o.names, name) != o.names.end(); });
  return found == options.end() || found->argument ? nullptr : &*found;
}

Given read(const std::vector<OptionText>& options, const std::vector<std::string>& words) {
  Given given;
  for (const std::string& word : words) {
    if (word == "=") continue;  // a shell that parts words there
    if (given.waits != nullptr) {
      given.waits = nullptr;
    } else if (word == "--" && !given.ended) {
      given.ended = true;
    } else if (!given.ended && word.size() > 1 && word.front() == '-') {
      const std::size_t equals = word.find('=');
      given.options.push_back(word.substr(0, equals));
      const OptionText* const option = find(options, given.options.back());
      if (option != nullptr && !option->value.empty() && equals == std::string::npos) given.waits = option;
    } else {
      given.arguments.push_back(word);
    }
  }
  return given;
}

void add_options(Candidates& candidates, const std::vector<OptionText>& options, const Given& given) {
  for (const OptionText& option : options) {
    if (option.argument) continue;
    const bool there = std::ranges::any_of(option.names, [&](const std::string& name) {
      return std::ranges::find(given.options, name) != given.options.end();
    });
    if (!there || option.repeated) candidates.add(option.name(), option.text);
  }
}

void add_argument(Candidates& candidates, const VerbText& verb, const Given& given) {
  std::size_t place = 0;
  for (const OptionText& option : verb.options) {
    if (!option.argument) continue;
    if (place == given.arguments.size() || option.repeated) {
      add_values(candidates,
                 place == 0 ? option.value : value_behind(verb.name, given.arguments.front(), option.value));
      return;
    }
    ++place;
  }
}

std::string of_verb(const VerbText& verb, const std::vector<std::string>& words, const std::string& word) {
  const Given given = read(verb.options, words);
  const std::size_t equals = word.find('=');
  if (given.waits == nullptr && !given.ended && word.starts_with("--") && equals != std::string::npos) {
    Candidates values(std::string_view(word).substr(equals + 1));
    if (const OptionText* const option = find(verb.options, word.substr(0, equals))) add_values(values, option->value);
    return values.take();
  }
  Candidates candidates(word == "=" ? std::string_view() : std::string_view(word));
  if (given.waits != nullptr)
    add_values(candidates, given.waits->value);
  else if (!given.ended && word.starts_with('-'))
    add_options(candidates, verb.options, given);
  else
    add_argument(candidates, verb, given);
  return candidates.take();
}

constexpr std::string_view kBash = R"shell(# bash completion for toolcomp: the command itself says what may stand where.
_toolcomp() {
  local command=${COMP_WORDS[0]/#\~/$HOME} word=${COMP_WORDS[COMP_CWORD]} line
  [ "$word" != = ] || word=
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :files | :folders)
        local kind=-f
        [ "$line" = :files ] || kind=-d
        compopt -o filenames 2>/dev/null
        while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen "$kind" -- "$word")
        ;;
      *) COMPREPLY+=("${line%%$'\t'*}") ;;
    esac
  done < <("$command" complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -F _toolcomp toolcomp
)shell";

constexpr std::string_view kZsh = R"shell(#compdef toolcomp
# zsh completion for toolcomp: the command itself says what may stand where.
_toolcomp() {
  local line value kind
  local -a values given
  given=("${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}")
  while IFS= read -r line; do
    case $line in
      :*) kind=$line ;;
      *) value=${line%%$'\t'*}; values+=("${value//:/\\:}:${line#*$'\t'}") ;;
    esac
  done < <(${~words[1]} complete "${given[@]}" 2>/dev/null)
  [[ $PREFIX == --*=* ]] && compset -P '*='
  (( ${#values} )) && _describe toolcomp values
  [[ $kind == :files ]] && _files
  [[ $kind == :folders ]] && _files -/
  return 0
}
[[ ${funcstack[1]} == _toolcomp ]] && _toolcomp "$@" || compdef _toolcomp toolcomp
)shell";

constexpr std::string_view kFish = R"shell(# fish completion for toolcomp: the command itself says what may stand where.
function __toolcomp_complete
    set -l words (commandline -opc)
    set -l command (string replace -r '^~' $HOME -- $words[1])
    set -e words[1]
    set -l word (commandline -ct)
    set -l head (string match -r -- '^--[^=]*=' $word)
    set -q head[1]; or set head ''
    for line in ($command complete $words "$word" 2>/dev/null)
        switch $line
            case :files
                printf '%s\n' $head(__fish_complete_path (string replace -- "$head" '' $word))
            case :folders
                printf '%s\n' $head(__fish_complete_directories (string replace -- "$head" '' $word))
            case '*'
                printf '%s\n' "$head$line"
        end
    end
end
complete -c toolcomp -f -a '(__toolcomp_complete)'
)shell";

}  // namespace

std::string_view completion_script(std::string_view shell) {
  return shell == "bash" ? kBash : shell == "zsh" ? kZsh : kFish;
}

std::string completions(const CommandLine& line, const std::vector<std::string>& words) {
  if (words.empty()) return "";
  const std::vector<std::string> before(words.begin(), words.end() - 1);
  const std::vector<VerbText> verbs = line.verbs();
  const VerbText program{"", "", true, line.options()};
  // The verb is the first word that is neither an option nor the value of one.
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Given given = read(program.options, {before.begin(), before.begin() + static_cast<std::ptrdiff_t>(i) + 1});
    if (given.arguments.empty() || given.arguments.front() == "help") continue;
    const auto verb = std::ranges::find(verbs, given.arguments.back(), &VerbText::name);
    if (verb == verbs.end() || !verb->listed) return "";
    if (given.arguments.size() > 1) return "";  // behind help
    return of_verb(*verb, {before.begin() + static_cast<std::ptrdiff_t>(i) + 1, before.end()}, words.back());
  }
  if (read(program.options, before).waits != nullptr || words.back().starts_with('-'))
    return of_verb(program, before, words.back());
  Candidates candidates(words.back());
  for (const VerbText& verb : verbs)
    if (verb.listed) candidates.add(verb.name, verb.about);
  candidates.add("help", "What a verb takes");
  return candidates.take();
}

}  // namespace toolcomp::cli
