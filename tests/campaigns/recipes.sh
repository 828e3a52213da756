# What the tests of the recipes share. Source it after tests/cli/harness.sh.
recipes=$sources/campaigns/recipes

# by_hand: a campaign of eight shards, and what is merged of them when they are computed one after the other.
by_hand() {
  cat >campaign.json <<'JSON'
{"format":"durero-campaign","version":1,"system":"durero","seed":1,"rays_of_a_shard":128,"shards":8,
 "families":["generic"],"types":["esfera"]}
JSON
  for shard in 0 1 2 3 4 5 6 7; do run 0 conform shard campaign.json $shard --output "hand-$shard.json"; done
  run 0 conform merge campaign.json hand-*.json --output by-hand.json
}

# merges_alike FOLDER
merges_alike() {
  run 0 conform merge campaign.json "$1" --output "$1.json"
  has out "8 of 8 shards"
  same by-hand.json "$1.json"
}
