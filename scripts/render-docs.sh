#!/usr/bin/env bash
# Renders the pictures of the README and of docs anew, from the samples, into docs/images.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target morphkit_cli morphkit_paint
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build/release/samples/morphkit_paint "$work" > /dev/null

# strip NAME WIDTH HEIGHT OUT: five moments side by side, over a quiet grey
strip() {
  local inputs=() scaled="" row="" i=0
  for t in 0 0.25 0.5 0.75 1; do
    build/release/bin/morphkit morph "$work/$1.json" -t "$t" -o "$work/$1-$t.png" --quiet
    inputs+=(-i "$work/$1-$t.png")
    scaled+="[$i]scale=$2:$3[p$i];"
    row+="[p$i]"
    i=$((i + 1))
  done
  ffmpeg -v error -y "${inputs[@]}" -frames:v 1 -update 1 -filter_complex \
    "${scaled}${row}hstack=5[row];color=0x909aa4:s=$(($2 * 5))x$3[grey];[grey][row]overlay=shortest=1,format=rgb24" "$4"
}

mkdir -p docs/images
strip portraits 240 300 docs/images/portraits.png
strip objects 240 240 "$work/objects.png"
strip scenes 240 135 "$work/scenes.png"
ffmpeg -v error -y -i "$work/objects.png" -i "$work/scenes.png" -frames:v 1 -update 1 -filter_complex vstack \
  docs/images/more.png

# A mesh at work: an even grid is drawn on the picture, which then goes through the passes, rows first.
build/release/bin/morphkit export "$work/mesh.json" "$work/woman.mesh" "$work/man.mesh" --quiet
ffmpeg -v error -y -i "$work/woman.png" -vf 'drawgrid=w=iw/20:h=ih/25:t=2:c=white@0.8' -frames:v 1 -update 1 "$work/grid.png"
build/release/bin/morphkit warp "$work/grid.png" --mesh "$work/man.mesh" --order rows-first \
  --intermediate "$work/rows.png" -o "$work/both.png" --quiet
ffmpeg -v error -y -i "$work/grid.png" -i "$work/rows.png" -i "$work/both.png" -frames:v 1 -update 1 -filter_complex \
  '[0]scale=384:480[a];[1]scale=384:480[b];[2]scale=384:480[c];[a][b][c]hstack=3,format=rgb24' docs/images/mesh.png

# What filters do where a picture shrinks: rings, drawn finer towards the corners, made smaller by a single line.
ffmpeg -v error -y -f lavfi -i "nullsrc=s=600x600,geq=lum='128+112*cos(0.0042*((X-300)*(X-300)+(Y-300)*(Y-300)))':cb=128:cr=128,format=gray" \
  -frames:v 1 -update 1 "$work/rings.png"
rings=()
for filter in bilinear bicubic area mitchell lanczos; do
  cat > "$work/rings-$filter.json" <<END
{"morphkit": 1, "source": {"image": "rings.png"}, "destination": {"image": "rings.png"},
 "features": [{"id": "all", "line": {"source": [[30, 300], [570, 300]], "destination": [[195, 300], [405, 300]]}}],
 "warp": {"scale": "uniform", "filter": "$filter"}, "transition": {"dissolve": {"ease": "step", "at": 1}},
 "output": {"size": [600, 600]}}
END
  build/release/bin/morphkit morph "$work/rings-$filter.json" -t 0.999 -o "$work/rings-$filter.png" --quiet
  rings+=(-i "$work/rings-$filter.png")
done
ffmpeg -v error -y "${rings[@]}" -frames:v 1 -update 1 -filter_complex \
  '[0]crop=220:220[a];[1]crop=220:220[b];[2]crop=220:220[c];[3]crop=220:220[d];[4]crop=220:220[e];[a][b][c][d][e]hstack=5,format=gray' \
  docs/images/filters.png
