import numpy as np, acoustic_fem, geometry, localize, warnings, subprocess, sys, pathlib
warnings.simplefilter("ignore")
from localize.embedded.tables import embedded_tables
from localize.embedded.source import source_files
from localize.signals.array_response import response_of
rows=[]
for name,prec in (("array-2x6","float32"),("line-2","float32"),("fingertip-3x4","float32"),("glove","float32"),("large-area-64","float32"),("array-2x6","int16"),("line-2","int16"),("glove","int16")):
    lib=acoustic_fem.solve(geometry.prototype(name),np.arange(1.,501.),"lumped")
    t=embedded_tables(lib,prec)
    out=pathlib.Path(f'/tmp/ece/w'); out.mkdir(exist_ok=True)
    for n,s in source_files(t).items(): (out/n).write_text(s)
    m=localize.TouchGenerator(response_of(lib),3,"evaluation","design").samples(0,2).signals.double().numpy()
    np.ascontiguousarray(np.concatenate(list(m),axis=1).T.astype(np.float32)).tofile('/tmp/board/samples.f32')
    f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16".split()
    crt=subprocess.run(["arm-none-eabi-gcc",*f,"-print-file-name=rdimon-crt0.o"],capture_output=True,text=True).stdout.strip()
    r=subprocess.run(["arm-none-eabi-gcc",*f,"-std=c99","-O2","-ffp-contract=fast","-DSURE=1e30f",f"-I{out}","startup.c","board.c",str(out/"touch_decoder.c"),str(out/"touch_tables.c"),"-T","board.ld","-nostartfiles",crt,"--specs=rdimon.specs","-lc","-lrdimon","-lm","-o","w.elf"],cwd="/tmp/board",capture_output=True,text=True)
    if r.returncode: print(name,r.stderr[-300:]); continue
    q=subprocess.run("timeout 200 qemu-system-arm -M mps2-an386 -cpu cortex-m4 -nographic -monitor none -serial none -semihosting-config enable=on,target=native -icount shift=0 -kernel w.elf".split(),cwd="/tmp/board",capture_output=True,text=True).stdout.splitlines()
    c=[int(l.split()[4])*40 for l in q if len(l.split())>5]
    el=t.reflections.shape[1]; 
    flash=sum(x.nbytes for x in (t.whitening,t.eigenvalues,t.half_log_determinant,t.reflections,t.couplings)) + (t.steps.nbytes if t.steps is not None else 0)+(t.beside.nbytes if t.beside is not None else 0)
    rows.append((name,prec,len(t.microphones),t.point_count,t.size,t.rank,el,max(c),min(c),len(c),flash)); print(rows[-1],flush=True)
