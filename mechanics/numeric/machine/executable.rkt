#lang racket/base
;; Machine code that runs: memory for it, and procedures of flvectors.
;;
;; Code is written in pages of memory of its own, which then may be run and no longer written; they
;; are given back when nothing refers to the procedure any more.  A procedure is called as one of C
;; is, with the addresses of what its flvectors hold; while it runs nothing else does, so that they
;; stay where they are.
;;
;; This is for Racket CS on x86-64, on Linux and macOS; and where a system forbids new code, there
;; are no such procedures either.

(require ffi/unsafe
         ffi/unsafe/alloc
         ffi/unsafe/vm)

(provide machine? flvector-data C-function
         (protect-out machine-procedures))

;; Is there a processor that the assembler knows, and the way to call that is known here?
(define (machine?)
  (and (eq? 'chez-scheme (system-type 'vm))
       (eq? 'x86_64 (system-type 'arch))
       (memq (system-type 'os*) '(linux macosx))
       #t))

;; code : bytes; entries : list of (where type ...), where a procedure begins and what it is given:
;; up to six flvectors, type 'flvector, and before these perhaps a flonum, type 'flonum
;; -> list of procedures, run for what they store in the flvectors; or #f where there are none
(define (machine-procedures code entries)
  (define memory (and (machine?) (executable code)))
  (and memory
       (for/list ([e (in-list entries)]) (caller memory (car e) (cdr e)))))

;; What a procedure is given of an flvector is so many bytes before its first component.
(define flvector-data 9)

;; The address of a function of the library of C, or #f.
(define (C-function name)
  (define p (ffi-obj-ref name #f (lambda () #f)))
  (and p (address-of p)))

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

(define (give-back m) (munmap (executable-memory-pages m) (executable-memory-size m)))

;; Of nobody else, and of no file.
(define private+anonymous (if (eq? 'macosx (system-type 'os*)) #x1002 #x22))

(define allocate
  ((allocator give-back)
   (lambda (size)
     (define address (mmap #f size may-read-and-write private+anonymous -1 0))
     (and address
          (not (= address -1))
          (executable-memory (cast address _intptr _pointer) size)))))

;; ---------------------------------------------------------------------------
;; Calls

(define (caller m where types)
  (define run ((caller-of types) (+ where (address-of (executable-memory-pages m)))))
  (case (length types)
    [(1) (lambda (a) (run a) (void/reference-sink m))]
    [(2) (lambda (a b) (run a b) (void/reference-sink m))]
    [(3) (lambda (a b c) (run a b c) (void/reference-sink m))]
    [(4) (lambda (a b c d) (run a b c d) (void/reference-sink m))]
    [(5) (lambda (a b c d e) (run a b c d e) (void/reference-sink m))]
    [(6) (lambda (a b c d e f) (run a b c d e f) (void/reference-sink m))]
    [(7) (lambda (a b c d e f g) (run a b c d e f g) (void/reference-sink m))]))

;; types -> (address -> procedure); each is compiled once, which takes longer than most code here.
(define callers (make-hash))

(define (caller-of types)
  (hash-ref! callers types
             (lambda ()
               (vm-eval `(lambda (address)
                           (foreign-procedure address ,(map C-type types) void))))))

(define (C-type type)
  (if (eq? type 'flonum) 'double 'scheme-object))
