#lang racket/base
;; Machine code that runs: memory for it, and procedures of flvectors.
;;
;; Code is written in pages of memory of its own, which then may be run and no longer written; they
;; are given back when nothing refers to the procedure any more.  A procedure is called as one of C
;; is, with the addresses of its flvectors' contents; while it runs nothing else does, so that they
;; stay where they are.
;;
;; This is for Racket CS on x86-64 under Linux, where it is tested; and where a system forbids new
;; code, there are no such procedures either, nor are there more at once than a system has areas of
;; memory for.

(require ffi/unsafe
         ffi/unsafe/alloc
         ffi/unsafe/vm
         racket/flonum
         "../../error/computed-once.rkt")

(provide machine? flvector-data C-function
         (protect-out machine-procedures))

;; code : bytes; entries : list of (where type ...), the beginning and the arguments of a procedure:
;; up to six flvectors, type 'flvector, or vectors, type 'vector, and before these perhaps a flonum,
;; type 'flonum
;; -> list of procedures, run for the numbers they store in flvectors; or #f where there are none
;; They take their arguments as they are: vectors as long as the code believes.
(define (machine-procedures code entries)
  (define memory (and (machine?) (executable code)))
  (and memory
       (for/list ([e (in-list entries)]) (caller memory (car e) (cdr e)))))

;; ---------------------------------------------------------------------------
;; The machine at hand

;; Racket CS on x86-64 Linux, vectors laid out as expected, MECHANICS_NO_MACHINE_CODE unset?
(define machine?
  (once
   (lambda ()
     (with-handlers ([exn:fail? (lambda (_) #f)])
       (and (not (getenv "MECHANICS_NO_MACHINE_CODE"))
            (known-processor?)
            (flvectors-as-known?)
            (vectors-as-known?))))))

;; The address that a procedure receives of an flvector, or of a vector, is so many bytes before its
;; first component.  A component of a vector is an address like this, or eight times a fixnum.
(define flvector-data 9)

(define (known-processor?)
  (and (eq? 'chez-scheme (system-type 'vm))
       (eq? 'x86_64 (system-type 'arch))
       (eq? 'linux (system-type 'os*))
       (memq (vm-eval '(machine-type)) '(ta6le a6le))
       #t))

;; Are components where this file expects them?  They were in all versions so far.
(define (flvectors-as-known?)
  (define object-ref (vm-eval '($primitive $object-ref)))
  (define v (flvector 1.5 -2.5 0.75))
  (for/and ([x (in-flvector v)] [k (in-naturals)])
    (eqv? x (object-ref 'double v (+ flvector-data (* 8 k))))))

(define (vectors-as-known?)
  (define object-ref (vm-eval '($primitive $object-ref)))
  (define u (flvector 1.5))
  (define v (vector 7 u -3))
  (define (component type k) (object-ref type v (+ flvector-data (* 8 k))))
  (and (eqv? 56 (component 'integer-64 0))
       (eq? u (component 'scheme-object 1))
       (eqv? -24 (component 'integer-64 2))))

;; The address of a function of the library of C, a symbol; or #f.
(define (C-function name)
  (hash-ref! addresses name
             (lambda ()
               (define p (ffi-obj-ref name #f (lambda () #f)))
               (and p (address-of p)))))

(define addresses (make-hasheq))

(define (address-of p) (cast p _pointer _intptr))

;; ---------------------------------------------------------------------------
;; Memory

;; pages : their address; size : in bytes
(struct executable-memory (pages size) #:authentic)

(define-values (may-read-and-write may-read-and-run) (values 3 5))

(define (executable code)
  (define size (bytes-length code))
  (define m (allocate size))
  (cond [(not m) #f]
        [else
         (memcpy (executable-memory-pages m) code size)
         (and (zero? (mprotect (executable-memory-pages m) size may-read-and-run)) m)]))

(define-syntax-rule (define-C name type)
  (define name (get-ffi-obj 'name #f type (lambda () (lambda arguments #f)))))

(define-C mmap (_fun _pointer _size _int _int _int _intptr -> _intptr))
(define-C mprotect (_fun _pointer _size _int -> _int))
(define-C munmap (_fun _pointer _size -> _int))

;; So many pieces are there now, and may be: a system counts areas of memory, of which Linux grants
;; a process 65,530, and Racket takes its own from these as well.
(define pieces 0)
(define most-pieces 10000)
(define (count! x) (set! pieces (+ pieces x)))

(define (give-back m)
  (count! -1)
  (munmap (executable-memory-pages m) (executable-memory-size m)))

;; Memory of this process alone, and of no file
(define private+anonymous #x22)

;; -> executable-memory, or #f.  Memory allocated here is given back by nobody but a garbage
;; collection and the end of a place, whatever custodian shuts down; nothing else happens meanwhile.
(define allocate
  ((allocator give-back)
   (lambda (size)
     (define address
       (and (< pieces most-pieces)
            (mmap #f size may-read-and-write private+anonymous -1 0)))
     (and address
          (not (= address -1))
          (begin (count! 1)
                 (executable-memory (cast address _intptr _pointer) size))))))

;; ---------------------------------------------------------------------------
;; Calls

;; The procedure keeps the memory.
(define (caller m where types)
  ((caller-of types) (+ where (address-of (executable-memory-pages m))) m))

;; types -> (address memory -> procedure); each is compiled once, which takes longer than most code
;; here.
;; Threads that ask at once, or are killed in between, compile one twice, no more.
(define (caller-of types)
  (define k (+ (* 2 (length types)) (if (memq 'flonum types) 1 0)))
  (or (vector-ref callers k)
      (let ([make (vm-eval (calling types))])
        (vector-set! callers k make)
        make)))

(define callers (make-vector 16 #f))

(define (calling types)
  (define names (for/list ([k (in-range (length types))]) (string->symbol (format "x~a" k))))
  `(lambda (address memory)
     (let ([run (foreign-procedure address ,(map C-type types) void)])
       (lambda ,names
         (run ,@names)
         (keep-live memory)))))

(define (C-type type)
  (if (eq? type 'flonum) 'double 'scheme-object))
