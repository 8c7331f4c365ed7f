-- What a study by protocols/rosen2010.json found, in the order of chapter 7's tables: for the command line of SQLite.
-- Beside each number stands what the text reports (section 7.4), where it does. Times are of trials in which the object was
-- found in time, as in the text.
.mode column
.headers on
.nullvalue -

.print
.print --- Subjects and sessions
SELECT subject.kind, count(DISTINCT subject_id) AS subjects, count(*) AS sessions,
       sum((SELECT count(*) FROM final_trial AS t WHERE t.subject_id = session.subject_id
                                                   AND t.session_number = session.session_number)) AS trials
FROM session JOIN subject USING (subject_id) GROUP BY subject.kind;

.print
.print --- Section 7.4.2: seconds to find objects, first session of all subjects
WITH text (moving, view, seconds, over) AS (
  VALUES (0, 'ppc', 20.4, 6.35), (0, 'gc', 13.3, 6.35), (1, 'ppc', 12.6, 1.9), (1, 'gc', 9.11, 0.27))
SELECT CASE moving WHEN 0 THEN 'stationary' ELSE 'moving' END AS objects, view, count(*) AS trials,
       round(avg(CASE WHEN NOT censored THEN response_s END), 1) AS found_s, text.seconds AS text_s,
       round(100.0 * avg(censored), 1) AS time_over_percent, text.over AS text_percent,
       round(avg(response_s), 1) AS with_60_s
FROM final_trial JOIN text USING (moving, view)
WHERE task = 'find' AND session_number = 1 GROUP BY moving, view ORDER BY moving, view DESC;

.print
.print --- Table 7.1: seconds to find objects, subjects with three sessions
WITH text (moving, view, session_number, seconds) AS (
  VALUES (0, 'ppc', 1, 19.7), (0, 'ppc', 2, 15.7), (0, 'ppc', 3, 14.3), (0, 'gc', 1, 12.9), (0, 'gc', 2, 10.9),
         (0, 'gc', 3, 9.2), (1, 'ppc', 1, 11.6), (1, 'ppc', 2, 10.8), (1, 'ppc', 3, 9.0), (1, 'gc', 1, 8.6),
         (1, 'gc', 2, 8.5), (1, 'gc', 3, 8.2))
SELECT CASE moving WHEN 0 THEN 'stationary' ELSE 'moving' END AS objects, session_number AS session,
       round(avg(CASE WHEN view = 'ppc' AND NOT censored THEN response_s END), 1) AS ppc_s,
       max(CASE WHEN view = 'ppc' THEN text.seconds END) AS text_ppc_s,
       round(avg(CASE WHEN view = 'gc' AND NOT censored THEN response_s END), 1) AS gc_s,
       max(CASE WHEN view = 'gc' THEN text.seconds END) AS text_gc_s,
       round(100.0 * avg(CASE WHEN view = 'ppc' THEN censored END), 1) AS ppc_over_percent,
       round(100.0 * avg(CASE WHEN view = 'gc' THEN censored END), 1) AS gc_over_percent
FROM final_trial JOIN text USING (moving, view, session_number)
WHERE task = 'find' AND subject_id IN (SELECT subject_id FROM session WHERE session_number = 3)
GROUP BY moving, session_number;

.print
.print --- Figure 7.5: stationary objects by location, first session of all subjects
SELECT case_label AS location,
       round(avg(CASE WHEN view = 'ppc' AND NOT censored THEN response_s END), 1) AS ppc_s,
       round(avg(CASE WHEN view = 'gc' AND NOT censored THEN response_s END), 1) AS gc_s,
       round(100.0 * avg(CASE WHEN view = 'ppc' THEN censored END)) AS ppc_over_percent,
       round(100.0 * avg(CASE WHEN view = 'gc' THEN censored END)) AS gc_over_percent
FROM final_trial WHERE task = 'find' AND NOT moving AND session_number = 1
GROUP BY case_label ORDER BY min(case_index);

.print
.print --- Section 7.4.3 and Table 7.2: percent of counts that are right, first session of all subjects
WITH text (moving, condition, ppc, gc) AS (
  VALUES (0, 'all', 43.6, 90.2), (1, 'all', 40.4, 92.4), (0, '5 s', 41.3, 84.7), (0, '10 s', 37.6, 93.0),
         (0, '20 s', 56.5, 90.8), (0, 'duplicate colours', 40.9, 84.9), (0, 'unique colours', 45.5, 94.4)),
counts AS (
  SELECT moving, view, correct, 'all' AS condition, 0 AS rank FROM final_trial WHERE task = 'count' AND session_number = 1
  UNION ALL
  SELECT moving, view, correct, printf('%g s', exposure_s), exposure_s FROM final_trial
  WHERE task = 'count' AND session_number = 1
  UNION ALL
  SELECT moving, view, correct, iif(duplicate_colors, 'duplicate colours', 'unique colours'), 100 + duplicate_colors
  FROM final_trial WHERE task = 'count' AND session_number = 1)
SELECT CASE counts.moving WHEN 0 THEN 'stationary' ELSE 'moving' END AS objects, counts.condition, count(*) AS trials,
       round(100.0 * avg(CASE WHEN view = 'ppc' THEN correct END), 1) AS ppc, text.ppc AS text_ppc,
       round(100.0 * avg(CASE WHEN view = 'gc' THEN correct END), 1) AS gc, text.gc AS text_gc
FROM counts LEFT JOIN text ON text.moving = counts.moving AND text.condition = counts.condition
GROUP BY counts.moving, counts.condition ORDER BY counts.moving, min(rank);

.print
.print --- Table 7.3: percent of counts that are right, subjects with three sessions
WITH text (moving, session_number, ppc, gc) AS (
  VALUES (0, 1, 38.8, 89.6), (0, 2, 50.4, 98.4), (0, 3, 58.4, 98.4), (1, 1, 39.6, 90.8), (1, 2, 46.0, 98.0),
         (1, 3, 47.6, 95.6))
SELECT CASE moving WHEN 0 THEN 'stationary' ELSE 'moving' END AS objects, session_number AS session,
       round(100.0 * avg(CASE WHEN view = 'ppc' THEN correct END), 1) AS ppc, max(text.ppc) AS text_ppc,
       round(100.0 * avg(CASE WHEN view = 'gc' THEN correct END), 1) AS gc, max(text.gc) AS text_gc
FROM final_trial JOIN text USING (moving, session_number)
WHERE task = 'count' AND subject_id IN (SELECT subject_id FROM session WHERE session_number = 3)
GROUP BY moving, session_number;

.print
.print --- Mean error of counts: objects too many, or too few
SELECT CASE moving WHEN 0 THEN 'stationary' ELSE 'moving' END AS objects, view,
       round(avg(json_extract(measures_json, '$.count_error')), 2) AS mean_error
FROM final_trial WHERE task = 'count' GROUP BY moving, view ORDER BY moving, view DESC;

.print
.print --- Section 7.4.4: percent of paths that are right
WITH text (session_number, ppc, gc) AS (VALUES (1, 60.8, 64.0), (2, 72.0, 73.6), (3, 78.4, 76.0))
SELECT 'all, first session' AS who, 1 AS session,
       round(100.0 * avg(CASE WHEN view = 'ppc' THEN correct END), 1) AS ppc, 66.7 AS text_ppc,
       round(100.0 * avg(CASE WHEN view = 'gc' THEN correct END), 1) AS gc, 69.8 AS text_gc
FROM final_trial WHERE task = 'path' AND session_number = 1
UNION ALL
SELECT 'with three sessions', session_number, round(100.0 * avg(CASE WHEN view = 'ppc' THEN correct END), 1),
       max(text.ppc), round(100.0 * avg(CASE WHEN view = 'gc' THEN correct END), 1), max(text.gc)
FROM final_trial JOIN text USING (session_number)
WHERE task = 'path' AND subject_id IN (SELECT subject_id FROM session WHERE session_number = 3)
GROUP BY session_number;

.print
.print --- Section 7.4.5: survey, 1 for the pinhole to 5 for the graph camera
WITH text (field, mean) AS (VALUES ('easier_find', 4.5), ('easier_count', 4.98), ('easier_path', 2.7))
SELECT field, count(*) AS answers, round(avg(CAST(answer AS REAL)), 2) AS mean, text.mean AS text_mean
FROM final_answer JOIN text USING (field) WHERE form = 'survey' GROUP BY field;
