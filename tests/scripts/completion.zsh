# What zsh makes of words before a tab, typed in a terminal of its own. usage: zsh -f completion.zsh FOLDER TYPED WANTED
zmodload zsh/zpty
zpty shell "TERM=dumb zsh -f -i"
zpty -w shell "PS1=; fpath=($1 \$fpath); autoload -U compinit; compinit -u -D; print rea''dy"
zpty -r -m shell text "*ready*"
zpty -w -n shell "$2"$'\t'
text=
repeat 100; do
  sleep 0.1
  while zpty -r -t shell more; do text+=$more; done
  [[ $text == *"$3"* ]] && break
done
zpty -d shell
print -r -- $text
[[ $text == *"$3"* ]]
