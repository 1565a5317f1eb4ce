#!/bin/sh
# A controller in shell, for a control that runs one program at a time from files: here `toolcomp run`, which prints an
# event a line. docs/protocol.md says what goes to and fro.
simulator=${TOOLCOMP:-../../build/release/toolcomp}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
while IFS= read -r request; do
  case $request in
    *'"hello"'*)
      sections=$("$simulator" spec sections | sed -n 's/^\([a-z]*\/[a-z-]*\).*/"\1"/p' | paste -sd, -)
      printf '{"name":"one program at a time","version":"1","protocol":1,"sections":[%s],' "$sections"
      printf '"fields":["kind","line","n","type","cause","point","axes","number"]}\n'
      ;;
    *)
      printf '%s\n' "$request" >"$work/case.json"
      id=$(printf '%s\n' "$request" | sed 's/.*"id": *\("[^"]*"\).*/\1/')
      "$simulator" run "$work/case.json" --engine fast --notes off >"$work/events" 2>"$work/why"
      # 3: a word that is not supported ends the run; what is before it counts.
      case $? in 0 | 3) ran=yes ;; *) ran=no ;; esac
      if [ $ran = yes ]; then
        printf '{"id":%s,"events":[%s]}\n' "$id" "$(paste -sd, "$work/events")"
      else
        printf '{"id":%s,"error":"%s"}\n' "$id" "$(tr -d '"\\\n' <"$work/why")"
      fi
      ;;
  esac
done
