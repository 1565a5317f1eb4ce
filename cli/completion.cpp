// SPDX-License-Identifier: Apache-2.0
#include "cli/completion.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "cli/adapter_names.h"
#include "cli/help.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/generator.h"
#include "spec/clauses/clauses.h"

namespace toolcomp::cli {
namespace {

// Collects the candidates that begin with a word.
class Candidates {
 public:
  explicit Candidates(std::string word) : word_(std::move(word)) {}

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
  std::string word_;
  std::string text_;
};

// Up to a full stop that a capital follows: "No. 5003" is none.
std::string_view first_sentence(std::string_view text) {
  std::size_t end = text.find(". ");
  while (end != std::string_view::npos && (end + 2 >= text.size() || text[end + 2] < 'A' || text[end + 2] > 'Z'))
    end = text.find(". ", end + 1);
  return text.substr(0, end);
}

// What an option's word stands for.
void add_values(Candidates& candidates, const std::string& value) {
  if (value.find('|') != std::string::npos) return candidates.add_all(value);
  if (value == "SECTION")
    for (const std::string_view section : fuzz::sections()) candidates.add(section, "section");
  if (value == "CLAUSE")
    for (const spec::ClauseInfo& clause : spec::clauses()) candidates.add(clause.id, first_sentence(clause.text));
  if (value == "TARGET")
    for (const fuzz::Target& target : fuzz::targets()) candidates.add(target.name, "target");
  if (value == "CONTROLLER") candidates.add("spec", "the formal specification");
  if (value == "CONTROLLER" || value == "ADAPTER")
    for (const std::string& name : adapter_names({})) candidates.add(name, "adapter");
  if (value == "FILE" || value == "PROGRAM" || value == "SETUP") candidates.ask("files");
  if (value == "FOLDER") candidates.ask("folders");
}

// What the words before the one to be completed come to.
struct Given {
  const CLI::App* app = nullptr;  // the verb, or the program; none: a verb that there is not
  std::vector<const CLI::Option*> options;
  const CLI::Option* waits = nullptr;  // the option whose value comes next
  std::size_t arguments = 0;
  bool ended = false;  // by --
};

Given read(const CLI::App& program, const std::vector<std::string>& words) {
  Given given{&program, {}, nullptr, 0, false};
  for (const std::string& word : words) {
    if (word == "=") continue;  // a shell that parts words there
    if (given.waits != nullptr) {
      given.waits = nullptr;
    } else if (word == "--" && !given.ended) {
      given.ended = true;
    } else if (!given.ended && word.size() > 1 && word.front() == '-') {
      const std::size_t equals = word.find('=');
      const CLI::Option* const option = given.app->get_option_no_throw(word.substr(0, equals));
      if (option == nullptr) continue;
      given.options.push_back(option);
      if (takes_value(*option) && equals == std::string::npos) given.waits = option;
    } else if (const auto verbs = listed_verbs(*given.app); !verbs.empty()) {
      const auto verb = std::ranges::find(verbs, word, &CLI::App::get_name);
      given.app = verb == verbs.end() ? nullptr : *verb;
      if (given.app == nullptr) return given;
    } else {
      ++given.arguments;
    }
  }
  return given;
}

void add_options(Candidates& candidates, const Given& given) {
  for (const CLI::Option* option : options_of(*given.app))
    if (is_repeated(*option) || std::ranges::find(given.options, option) == given.options.end())
      candidates.add(names_of(*option).back(), text_of(*option));
}

void add_argument(Candidates& candidates, const Given& given) {
  for (const CLI::App* verb : listed_verbs(*given.app)) candidates.add(verb->get_name(), summary_of(*verb));
  std::size_t place = 0;
  for (const CLI::Option* argument : arguments_of(*given.app))
    if (place++ == given.arguments || is_repeated(*argument)) return add_values(candidates, argument->get_type_name());
}

constexpr std::string_view kBash = R"shell(# bash completion for toolcomp: the command itself lists what may follow.
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
# zsh completion for toolcomp: the command itself lists what may follow.
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

constexpr std::string_view kFish = R"shell(# fish completion for toolcomp: the command itself lists what may follow.
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

std::string completions(const CLI::App& program, std::vector<std::string> words) {
  if (words.empty()) return "";
  const std::string word = words.back() == "=" ? "" : words.back();
  words.pop_back();
  const bool help = !words.empty() && words.front() == "help";
  if (help) words.erase(words.begin());
  const Given given = read(program, words);
  if (given.app == nullptr) return "";
  const bool option = given.waits == nullptr && !given.ended && word.starts_with('-');
  const std::size_t equals = option ? word.find('=') : std::string::npos;
  Candidates candidates(equals == std::string::npos ? word : word.substr(equals + 1));
  if (equals != std::string::npos) {
    if (const CLI::Option* const named = given.app->get_option_no_throw(word.substr(0, equals)))
      add_values(candidates, named->get_type_name());
  } else if (given.waits != nullptr) {
    add_values(candidates, given.waits->get_type_name());
  } else if (option) {
    add_options(candidates, given);
  } else {
    add_argument(candidates, given);
    if (words.empty() && !help) candidates.add("help", "What a verb takes");
  }
  return candidates.take();
}

}  // namespace toolcomp::cli
