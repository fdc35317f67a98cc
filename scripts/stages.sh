# For .ci/run and scripts/nightly.sh: stages with a name, the time that each took, and which one failed.
current=""
summary=""
SECONDS=0

end_stage() {
  [[ -n $current ]] || return 0
  local took=$((SECONDS - began))
  summary+=$(printf '%4d:%02d  %s' $((took / 60)) $((took % 60)) "$current")$'\n'
}

stage() {
  end_stage
  current=$1
  began=$SECONDS
  printf '\n== %s  %s\n' "$(date +%T)" "$current"
}

finish() {
  end_stage
  printf '\n%s%4d:%02d  all passed\n' "$summary" $((SECONDS / 60)) $((SECONDS % 60))
}

trap 'end_stage; printf "\n%s== %s  FAILED: %s\n" "$summary" "$(date +%T)" "$current"' ERR
