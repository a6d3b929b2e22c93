set style data lines
set xlabel "Generation"

set title "Schaffer0_child NearMinusHalf"
plot \
"Schaffer0_child_log.txt" u 1:2 t "MIN", \
"Schaffer0_child_log.txt" u 1:3 t "AVG", \
"Schaffer0_child_log.txt" u 1:4 t "MAX"

pause -1

set title "Schaffer0_child NearHalf"
plot \
"Schaffer0_child_log.txt" u 1:6 t "MIN", \
"Schaffer0_child_log.txt" u 1:7 t "AVG", \
"Schaffer0_child_log.txt" u 1:8 t "MAX"

pause -1

set title "Schaffer0_child Answer"
plot \
"Schaffer0_child_log.txt" u 1:10 t "MIN", \
"Schaffer0_child_log.txt" u 1:11 t "AVG", \
"Schaffer0_child_log.txt" u 1:12 t "MAX"

pause -1

