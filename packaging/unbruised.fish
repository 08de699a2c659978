# fish completion of unbruised: commands, the options that a command's --help names, studies and run directories.
function __unbruised_commands
    unbruised --help 2>/dev/null | awk '/^Subcommands:/ { on = 1; next } on && /^  [a-z]/ { name = $1; $1 = ""; print name "\t" substr($0, 2) } /^$/ { on = 0 }'
end
function __unbruised_options
    set -l words (commandline -opc)
    unbruised $words[2] --help 2>/dev/null | grep -oE '(^|[ ,])--[a-z-]+' | tr -d ' ,' | sort -u
end
complete -c unbruised -n __fish_use_subcommand -f -a '(__unbruised_commands)'
complete -c unbruised -n 'not __fish_use_subcommand; and string match -q -- "-*" (commandline -ct)' -f -a '(__unbruised_options)'
