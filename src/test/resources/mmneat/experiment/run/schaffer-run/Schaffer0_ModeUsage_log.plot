set style data lines
set xlabel "Generation"
set yrange [0:]

set title "Schaffer0_ModeUsage Max Modes of Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:2 t "Max Modes of Best"

pause -1

set title "Schaffer0_ModeUsage Min Modes of Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:3 t "Min Modes of Best"

pause -1

set title "Schaffer0_ModeUsage Avg Modes of Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:4 t "Avg Modes of Best"

pause -1

set title "Schaffer0_ModeUsage Max Modes of Worst"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:5 t "Max Modes of Worst"

pause -1

set title "Schaffer0_ModeUsage Min Modes of Worst"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:6 t "Min Modes of Worst"

pause -1

set title "Schaffer0_ModeUsage Avg Modes of Worst"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:7 t "Avg Modes of Worst"

pause -1

set title "Schaffer0_ModeUsage 1 Mode Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:8 t "1 Mode Best"

pause -1

set title "Schaffer0_ModeUsage 2 Mode Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:9 t "2 Mode Best"

pause -1

set title "Schaffer0_ModeUsage 3 Mode Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:10 t "3 Mode Best"

pause -1

set title "Schaffer0_ModeUsage 4 Mode Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:11 t "4 Mode Best"

pause -1

set title "Schaffer0_ModeUsage 5 Mode Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:12 t "5 Mode Best"

pause -1

set title "Schaffer0_ModeUsage More Than 6 Modes Best"
plot \
"Schaffer0_ModeUsage_log.txt" u 1:13 t "More Than 6 Modes Best"

pause -1

