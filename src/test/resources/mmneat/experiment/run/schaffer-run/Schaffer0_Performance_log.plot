set style data lines
set xlabel "Generation"

set title "Schaffer0_Performance Total Eval Time"
plot \
"Schaffer0_Performance_log.txt" u 1:2 t "MIN", \
"Schaffer0_Performance_log.txt" u 1:3 t "AVG", \
"Schaffer0_Performance_log.txt" u 1:4 t "MAX"

pause -1

set title "Schaffer0_Performance Average Eval Time"
plot \
"Schaffer0_Performance_log.txt" u 1:6 t "MIN", \
"Schaffer0_Performance_log.txt" u 1:7 t "AVG", \
"Schaffer0_Performance_log.txt" u 1:8 t "MAX"

pause -1

set title "Schaffer0_Performance Trials"
plot \
"Schaffer0_Performance_log.txt" u 1:10 t "MIN", \
"Schaffer0_Performance_log.txt" u 1:11 t "AVG", \
"Schaffer0_Performance_log.txt" u 1:12 t "MAX"

pause -1

set title "Schaffer0_Performance Times All Levels Beaten"
plot \
"Schaffer0_Performance_log.txt" u 1:14 t "MIN", \
"Schaffer0_Performance_log.txt" u 1:15 t "AVG", \
"Schaffer0_Performance_log.txt" u 1:16 t "MAX"

pause -1

set title "Schaffer0_Performance Times Time Limit Reached"
plot \
"Schaffer0_Performance_log.txt" u 1:18 t "MIN", \
"Schaffer0_Performance_log.txt" u 1:19 t "AVG", \
"Schaffer0_Performance_log.txt" u 1:20 t "MAX"

pause -1

set title "Schaffer0_Performance Times Died"
plot \
"Schaffer0_Performance_log.txt" u 1:22 t "MIN", \
"Schaffer0_Performance_log.txt" u 1:23 t "AVG", \
"Schaffer0_Performance_log.txt" u 1:24 t "MAX"

pause -1

