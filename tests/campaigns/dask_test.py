"""One small campaign on Dask: dask_test.py DURERO. Status 77 where Dask is absent."""
import sys
import tempfile

from support import Tester, python_with_dask, write_campaign

python = python_with_dask()
with tempfile.TemporaryDirectory() as folder:
    test = Tester(python, folder)
    campaign = write_campaign(folder, "durero")
    said = test.run(0, campaign, "run", "--workers", "2", "--twice", "0.3")
    test.expect(said == "", "nothing is said on standard error: %s" % said)
    expected = test.by_hand(campaign)
    test.expect(test.merged("run") == expected, "the bytes are those of shards computed by hand")
    again = sorted((test.folder / "run" / "again").iterdir())
    test.expect(1 <= len(again) <= 11, "some shards, not all, were computed twice: %d" % len(again))

    # What is there is not computed again, what is lacking is: a shard that was put aside comes back, and no other moves.
    kept, gone = test.shards("run")[0], test.shards("run")[5]
    before = kept.stat().st_ino
    gone.unlink()
    test.run(0, campaign, "run", "--workers", "1", "--twice", "0.3")
    test.expect(gone.exists() and kept.stat().st_ino == before, "only the shard that was lacking was computed")
    test.expect(test.merged("run") == expected, "and the bytes are the same")

    # A campaign may grow: shards that are there stay.
    longer = write_campaign(folder, "durero", shards=14)
    test.run(0, longer, "run", "--workers", "1", "--twice", "0.3")
    test.expect(len(test.shards("run")) == 14 and kept.stat().st_ino == before, "a longer campaign goes on with what is there")

    # A folder is of one campaign.
    other = write_campaign(folder, "durero", seed=2)
    said = test.run(2, other, "run")
    test.expect("it is of another campaign" in said, "another campaign is refused: %s" % said)

    # Where the system is absent the run ends with its words, and does not try every shard.
    absent = write_campaign(folder, "durero", system="no-such-system")
    said = test.run(2, absent, "absent", "--workers", "1", "--retries", "0")
    test.expect("no-such-system" in said and said.count("\n") == 2, "an absent system ends the run: %s" % said)
sys.exit(1 if test.failures else 0)
