#!/usr/bin/env bash
# namespaces.sh BUILD: runs the example on four ranks, each in a network namespace of its own, which talk by TCP over one bridge.
# Then compares the answer with that of one rank. Needs root. DELAY=1ms delays every packet, if the kernel has netem.
set -euo pipefail
example=$(realpath "$1")/bin/tamis_on_ranks
ranks=4 net=10.77.0

clean() {
  for ((i = 0; i < ranks; ++i)); do ip netns del "tamis$i" 2>/dev/null || true; done
  ip link del tamisbr 2>/dev/null || true
}
trap clean EXIT

ip link add tamisbr type bridge
ip addr add "$net.254/24" dev tamisbr
ip link set tamisbr up
for ((i = 0; i < ranks; ++i)); do
  ip netns add "tamis$i"
  ip link add "tamisve$i" type veth peer name eth0 netns "tamis$i"
  ip link set "tamisve$i" master tamisbr up
  ip -n "tamis$i" addr add "$net.$((i + 1))/24" dev eth0
  ip -n "tamis$i" link set eth0 up
  ip -n "tamis$i" link set lo up
  [[ -z ${DELAY:-} ]] || ip netns exec "tamis$i" tc qdisc add dev eth0 root netem delay "$DELAY"
done

# Ranks reach mpirun over the bridge, and each other only by TCP.
many=$(PMIX_MCA_ptl_tcp_if_include=$net.0/24 PMIX_MCA_ptl_tcp_remote_connections=1 PMIX_MCA_gds=hash \
  mpirun --allow-run-as-root --oversubscribe --mca mpi_yield_when_idle 1 --mca pml ob1 --mca btl tcp,self \
  --mca btl_tcp_if_include "$net.0/24" -x PMIX_MCA_gds -n "$ranks" \
  sh -c 'exec ip netns exec tamis$OMPI_COMM_WORLD_RANK "$@"' run \
  "$example")
ip netns exec tamis0 ip -s link show eth0
echo "$many"
[[ $many == $("$example") ]] && echo "the same as one rank"
