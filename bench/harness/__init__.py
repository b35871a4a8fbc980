# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmark programs by the paper's protocol and turns their answers into tables, pictures and a page.

cells       what is measured: a cell is problem x robot x planner x settings, a trial one seed or query of it
experiments which cells belong to which of the paper's tables and figures
journal     every answer, a line each, appended as it comes: what is there is never measured again
protocol    time limits, giving up, resuming
statistics  what the answers of a cell amount to
session     measures cells: all of the above, with real programs
pool, stop  several cores at once, and how they end
worker      a benchmark program that answers trials
problems    scenes, maps and queries as files
machine     where the measurements were made
page        RESULTS.md, tables; pictures: the figures; paper: the paper's own numbers
prose       its lines, at most 120 columns
"""
