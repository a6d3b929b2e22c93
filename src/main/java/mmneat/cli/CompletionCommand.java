package mmneat.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.StreamSupport;
import mmneat.cli.options.ArgumentSyntax;
import mmneat.cli.options.TaskOption;
import mmneat.experiment.parameters.Parameter;
import mmneat.experiment.parameters.ParameterCatalogue;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The command {@code completion}: prints a shell script that completes commands, options and values.
 *
 * <p>picocli's generator only completes options that start with a dash. So this class generates the script, from the
 * specifications that also parse the options.
 */
@Command(
        name = "completion",
        customSynopsis = "mmneat completion",
        description = {
            "Prints a script for bash and zsh that completes commands, options and values.",
            "",
            "Example (bash): source <(mmneat completion)",
            "Example (zsh): autoload -U bashcompinit; bashcompinit; source <(mmneat completion)",
            "",
        })
final class CompletionCommand extends ConsoleCommand implements Runnable {

    private static final String MAIN = "mmneat";

    /** The part of the script that does not depend on the commands. */
    private static final String LOGIC = """
            _mmneat() {
              local line=${COMP_LINE:0:COMP_POINT} word command name text prefix
              word=${line##*[[:space:]]}
              command=mmneat
              if [[ $line =~ ^[^[:space:]]+[[:space:]]+([a-z][a-z-]*)[[:space:]] ]]; then
                command=${BASH_REMATCH[1]:-${match[1]}}
              fi
              COMPREPLY=()
              if [[ $word != *=* ]]; then
                COMPREPLY=( $(compgen -W "$(_mmneat_words $command)" -- "$word") )
                [[ $word == */* || ${#COMPREPLY[@]} -eq 0 ]] && COMPREPLY=( $(compgen -f -- "$word") )
                return 0
              fi
              name=${word%%=*}
              text=${word#*=}
              # bash completes the part behind the sign, zsh the whole word.
              prefix=
              [[ -n ${ZSH_VERSION:-} || $COMP_WORDBREAKS != *=* ]] && prefix=$name=
              local values="$(_mmneat_values $command $name)"
              if [[ -n $values ]]; then
                COMPREPLY=( $(compgen -P "$prefix" -W "$values" -- "$text") )
              else
                COMPREPLY=( $(compgen -P "$prefix" -f -- "$text") )
              fi
            }
            complete -o nospace -F _mmneat mmneat
            """;

    @Override
    public void run() {
        CommandLine main = commandLine().getParent();
        StringBuilder script = new StringBuilder("# Completes the words of mmneat in bash and zsh.\n");
        List<String> commands = main.getSubcommands().keySet().stream().sorted().toList();
        script.append("_mmneat_words() {\n  case $1 in\n");
        for (String command : commands) {
            appendCase(script, command, words(spec(main, command)));
        }
        List<String> first = new ArrayList<>(commands);
        first.addAll(parameterNames());
        first.addAll(List.of("--help", "--version"));
        appendCase(script, MAIN, first);
        script.append("  esac\n}\n_mmneat_values() {\n  case $1:$2 in\n");
        for (String command : commands) {
            for (OptionSpec option : spec(main, command).options()) {
                appendCase(script, command + ":" + option.longestName(), values(option));
            }
        }
        for (Parameter parameter : parameters()) {
            // The task may also be a class, so the catalogue has no list of its values.
            List<String> values = parameter.name().equals("task") ? new TaskOption.Versions() : parameter.choices();
            appendCase(script, "*:" + parameter.name(), values);
        }
        script.append("  esac\n}\n").append(LOGIC);
        out().print(script);
        out().flush();
    }

    private static CommandSpec spec(CommandLine main, String command) {
        return Objects.requireNonNull(main.getSubcommands().get(command), command)
                .getCommandSpec();
    }

    private static void appendCase(StringBuilder script, String pattern, List<String> words) {
        if (!words.isEmpty()) {
            script.append("    ")
                    .append(pattern)
                    .append(") echo \"")
                    .append(String.join(" ", words))
                    .append("\" ;;\n");
        }
    }

    /** Returns the words that a command accepts. */
    private static List<String> words(CommandSpec command) {
        List<String> words = new ArrayList<>();
        ArgumentSyntax.names(command).forEach(name -> words.add(name + "="));
        if (ArgumentSyntax.takesParameters(command)) {
            words.addAll(parameterNames());
        }
        words.add("--help");
        return words;
    }

    /** Returns the values of an option; empty if they cannot be listed. */
    private static List<String> values(OptionSpec option) {
        if (option.completionCandidates() != null) {
            return StreamSupport.stream(option.completionCandidates().spliterator(), false)
                    .toList();
        }
        boolean isFlag = option.type() == boolean.class && !option.longestName().startsWith("-");
        return isFlag ? List.of("true", "false") : List.of();
    }

    private static List<Parameter> parameters() {
        return ParameterCatalogue.load().all().stream()
                .filter(parameter -> parameter.support() == Parameter.Support.YES)
                .toList();
    }

    private static List<String> parameterNames() {
        return parameters().stream()
                .map(parameter -> parameter.name() + "=")
                .sorted()
                .toList();
    }
}
