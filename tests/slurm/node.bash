# A Slurm of one node, this machine, with its own munged, slurmctld and slurmd in a temporary folder.

# start_node FOLDER: its commands go there by SLURM_CONF, which is exported; stopped by stop_node
start_node() {
    local folder=$1 command host user
    host=$(hostname -s) user=$(id -un)
    PATH=$PATH:/usr/sbin
    for command in munged slurmctld slurmd srun sbatch; do
        command -v "$command" >/dev/null || { echo "no $command here: apt-get install slurm-wlm munge" >&2; return 1; }
    done
    chmod 711 "$folder"
    mkdir -p "$folder"/{munge,state,spool}
    chmod 755 "$folder/munge"
    (umask 077 && head -c 1024 /dev/urandom >"$folder/key")
    munged --force --key-file="$folder/key" --socket="$folder/munge/socket" --pid-file="$folder/munged.pid" \
        --log-file="$folder/munged.log" --seed-file="$folder/munge.seed" 3>&-
    # Tasks that are queued again wait for as long as a credential lives.
    cat >"$folder/slurm.conf" <<END
ClusterName=tests
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket,cred_expire=5
CryptoType=crypto/munge
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=batch_sched_delay=1,sched_interval=5
KillWait=5
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4
END
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -f "$SLURM_CONF" 3>&-
    slurmd -f "$SLURM_CONF" -N "$host" 3>&-
    for ((wait = 0; wait < 100; wait++)); do
        sinfo -h -o %t 2>/dev/null | grep -q '^idle' && return 0
        sleep 0.2
    done
    tail -n 20 "$folder"/slurmctld.log "$folder"/slurmd.log >&2
    return 1
}

# stop_node FOLDER: until no daemon writes there any more
stop_node() {
    local daemon process wait
    for daemon in slurmd slurmctld munged; do
        [ -s "$1/$daemon.pid" ] || continue
        process=$(cat "$1/$daemon.pid")
        for ((wait = 0; wait < 100; wait++)); do
            kill "$process" 2>/dev/null || break
            sleep 0.2
        done
    done
}
