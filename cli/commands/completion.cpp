#include "cli/arguments/command.hpp"
#include "cli/arguments/parse.hpp"
#include "cli/terminal/output.hpp"

namespace cli {

/// A bash script made from the table of commands: commands, then the command's options, then files.
void run_completion(const Options&) {
    std::string names;
    std::string cases;
    for (const Command& command : commands()) {
        names += command.name;
        names += ' ';
        std::string flags = "--help";
        for (const std::string& flag : flags_of(command)) flags += " " + flag;
        cases += "        " + std::string(command.name) + ") words=\"" + flags + "\" ;;\n";
    }
    print(
        "# bash completion of lodlab; made by: lodlab completion\n"
        "_lodlab() {\n"
        "    local word=\"${COMP_WORDS[COMP_CWORD]}\" words=\"\"\n"
        "    if [[ $COMP_CWORD -eq 1 ]]; then\n"
        "        COMPREPLY=($(compgen -W \"" +
        names +
        "--help --version\" -- \"$word\"))\n"
        "        return\n"
        "    fi\n"
        "    case \"${COMP_WORDS[1]}\" in\n" +
        cases +
        "    esac\n"
        "    if [[ $word == -* ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
        "    else COMPREPLY=($(compgen -f -- \"$word\")); fi\n"
        "}\n"
        "complete -o filenames -F _lodlab lodlab\n");
}

}  // namespace cli
