"""Runs the shards of a campaign of `durero conform` on Dask distributed.

A campaign is a file that says which rays a system is asked; `durero conform shard CAMPAIGN N` asks the N-th part of them
and writes one small file. This package calls that command on many workers, and `durero conform merge` at the end.
"""
