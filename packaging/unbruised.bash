# bash completion of unbruised: commands, the options that a command's --help names, studies and run directories.
_unbruised() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" --help 2>/dev/null |
      awk '/^Subcommands:/ { on = 1; next } on && /^  [a-z]/ { print $1 } /^$/ { on = 0 }')" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" "$command" --help 2>/dev/null |
      grep -oE '(^|[ ,])--[a-z-]+' | tr -d ' ,' | sort -u)" -- "$word")
  fi
}
complete -o bashdefault -o default -F _unbruised unbruised
